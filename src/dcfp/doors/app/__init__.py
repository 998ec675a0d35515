"""The web page: records, a bearing, and what follows; a test machine; a design chart.

It calculates nothing of its own. Everything that belongs to a visitor is in a `Session` that only that visitor's page knows.
"""
