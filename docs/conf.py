"""How the pages are made: ``sphinx-build -W --keep-going -b html docs docs/_build/html``."""

import gc
import logging
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "_extensions"))

from dcfp.version import version as _version

# pages are trees of so many nodes that looking for those that nothing refers to any more takes longer than reading them
gc.set_threshold(200_000, 20, 20)
# before the package of the theme's colours, which asks every library for information
logging.basicConfig(level=logging.WARNING)

project = "dcfp"
author = "The dcfp developers"
project_copyright = "The dcfp developers, MIT licence"
release = version = _version()

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_gallery.gen_gallery",
    "sphinxcontrib.bibtex",
    "commands",
    "declared",
    "mathml",
    "public_names",
    "tables",
]
exclude_patterns = ["_build", "gallery"]
templates_path: list[str] = []
default_role = "py:obj"

myst_enable_extensions = ["attrs_block", "attrs_inline", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3
myst_dmath_double_inline = True

bibtex_bibfiles = ["../src/dcfp/schema/references.bib"]
bibtex_default_style = "plain"

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_attr_annotations = False
napoleon_custom_sections = [("Attributes", "params_style")]
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 90

sphinx_gallery_conf = {
    "examples_dirs": "gallery",
    "gallery_dirs": "figures",
    "filename_pattern": r"/plot_",
    "image_scrapers": ("drawing.scrape",),
    "reset_modules": (),
    "within_subsection_order": "FileNameSortKey",
    "download_all_examples": False,
    "write_computation_times": False,
    "show_memory": False,
    "show_signature": False,
    "min_reported_time": 1000,
    "remove_config_comments": True,
    "abort_on_example_error": True,
    "thumbnail_size": (420, 280),
}

html_theme = "furo"
html_title = f"dcfp {release}"
html_static_path = ["_static"]
html_css_files = ["dcfp.css"]
html_math_renderer = "mathml"
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {
        "color-brand-primary": "#004488",
        "color-brand-content": "#004488",
    },
    "dark_css_variables": {"color-brand-primary": "#7fb3e6", "color-brand-content": "#7fb3e6"},
}
