"""What everything is called, once: units, parameters, quantities, tables, checks, and the registries of what can be added."""
