"""Friction laws from measured tests."""
