"""The command ``dcfp``: parse, call, print. What it prints for scripts is fixed by the keys of its JSON."""
