"""Sources that buttons make beside their results: hidden in the pipeline browser, and deleted with what they belong to.

    from isthmus import entries                   # or: from isthmus_plugin, with the plugin loaded
    names = entries.make("ExtractSelection", residues, "1hew residue names")

The window reads the annotation ENTRY (Plugin/IsthmusBrowser.cxx); states keep annotations.
"""

try:
    from paraview import servermanager, simple
except ImportError:
    servermanager = simple = None  # with pip's vtk alone, isthmus.pipelines can still be imported

ENTRY, FOLLOWS = "IsthmusEntry", "IsthmusFollows"
# Ends scripts of Programmable Filters: ParaView puts numpy's all(), sum() and so on in place of Python's, also for the user.
TIDY = """
import builtins
for shadow in [name for name in dir(builtins) if str(getattr(globals().get(name), "__module__", "")).startswith(
        ("numpy", "vtkmodules", "paraview"))]:
    del globals()[shadow]
"""


def make(kind, source, name, hidden=True, follows=True, **properties):
    """The filter `kind` of paraview.simple on a source, or that source if `source` is None, with that name.

    hidden: whether the pipeline browser leaves it out. follows: whether it is deleted when `source` is; a hidden filter that
    follows nothing is deleted when nothing is made from it any more."""
    selected = simple.GetActiveSource()
    controller = servermanager.ParaViewPipelineController()
    made = getattr(servermanager.sources if source is None else servermanager.filters, kind)(no_update=True)
    controller.PreInitializeProxy(made)
    if source is not None:
        made.Input = source
    for key, value in properties.items():
        setattr(made, key, value)
    controller.PostInitializeProxy(made)
    made.SMProxy.SetAnnotation(ENTRY, "hidden" if hidden else "shown")
    if follows and source is not None:
        made.SMProxy.SetAnnotation(FOLLOWS, made.SMProxy.GetProducerProxy(0).GetXMLName())
    controller.RegisterPipelineProxy(made, name)
    simple.SetActiveSource(selected)
    return made


def forget():
    """Deletes what belongs to deleted sources: ParaView gives it the input of that source instead."""
    has_changed = True
    while has_changed:
        sources = list(simple.GetSources().values())
        known = {source.SMProxy.GetGlobalID() for source in sources}
        gone = [source for source in sources if _is_left_over(source.SMProxy, known)]
        for source in gone:
            simple.Delete(source)
        has_changed = bool(gone)


def _is_left_over(proxy, known):
    if proxy.HasAnnotation(FOLLOWS):
        made_from = proxy.GetProducerProxy(0) if proxy.GetNumberOfProducers() else None
        return made_from is None or made_from.GetGlobalID() not in known or (
            made_from.GetXMLName() != proxy.GetAnnotation(FOLLOWS))
    return proxy.GetAnnotation(ENTRY) == "hidden" and proxy.GetNumberOfProducers() > 0 and not any(
        proxy.GetConsumerProxy(i).IsA("vtkSMSourceProxy") for i in range(proxy.GetNumberOfConsumers()))
