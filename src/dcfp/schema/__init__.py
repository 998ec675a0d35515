"""What everything is called: quantities with their symbols and units, sources, and how both are read and shown."""
