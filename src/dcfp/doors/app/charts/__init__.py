"""Charts as options of ECharts: from results in the units of the package to what the browser draws in the visitor's."""
