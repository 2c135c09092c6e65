"""What the plugin brings along of the package isthmus: buttons, colours, charts and figures of the window.

    from isthmus_plugin import pipelines

Importable once the plugin is loaded, without the package isthmus; states and the window import this copy. Its
modules are those of the package under the same names.
"""
