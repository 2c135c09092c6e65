"""Settings of Sphinx; build_guide.py copies this file beside the generated pages."""

project = "Isthmus"
author = "the Isthmus authors"
copyright = "2026, the Isthmus authors"  # noqa: A001

extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath", "amsmath", "deflist"]
myst_heading_anchors = 4
myst_update_mathjax = False
suppress_warnings = ["toc.excluded"]
nitpicky = True
exclude_patterns = ["html"]

# MathJax 2 as Debian packages it: the site needs no network.
mathjax_path = "mathjax/MathJax.js"
mathjax2_config = {
    "jax": ["input/TeX", "output/SVG"],
    "extensions": ["tex2jax.js"],
    "TeX": {"extensions": ["AMSmath.js", "AMSsymbols.js"]},
    "showMathMenu": False,
    "messageStyle": "none",
}

html_theme = "furo"
html_title = "Isthmus"
html_show_sourcelink = False
html_copy_source = False
html_static_path = ["_static"]
html_css_files = ["guide.css"]
