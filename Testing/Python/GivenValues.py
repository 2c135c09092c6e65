"""A value given in the call that makes a filter is kept, also where it is the property's default.

ParaView proposes values from the data (the middle of a range, a share of the bounds) for what the call does
not give, and takes a property that is set to the value it has for one that is not given. Panels whose
properties have a proposal therefore have no default but a hint, DefaultWithoutData. For each property of
numbers of each filter: its default is given, with data; those with the hint are also left to ParaView, with
data and without.
"""

import tempfile
from pathlib import Path

from paraview import servermanager, simple

from good_data import filters, kinds, panels, producer
from lively_data import inputs
from outputs import output_of

NUMBERS = ("vtkSMDoubleVectorProperty", "vtkSMIntVectorProperty", "vtkSMIdTypeVectorProperty")
# On the data of this test the value proposed is the default.
NO_PROPOSAL = {("IonTransport", "MembraneCenter"), ("IonTransportOnSurface", "MembraneCenter"),
               ("IonTransportMovingSurface", "MembraneCenter"),
               ("TetCutaway", "PlaneOrigin"), ("HessianCurvature", "Scale"), ("CurvatureOnSurface", "Scale")}
control = servermanager.ParaViewPipelineController()


def hints():
    """{(proxy, property): default without data}, those of base proxies included."""
    found, bases, proposing = {}, {}, {}
    for root in panels():
        for proxy in root.iter("SourceProxy"):
            name = proxy.get("name")
            bases[name] = proxy.get("base_proxyname")
            found[name], proposing[name] = {}, set()
            for element in proxy.iter("DoubleVectorProperty"):
                hint = element.find("Hints/DefaultWithoutData")
                if hint is not None:
                    found[name][element.get("name")] = [float(word) for word in hint.get("values").split()]
                if element.find("ArrayRangeDomain") is not None or element.find("BoundsDomain") is not None:
                    proposing[name].add(element.get("name"))
            assert not proposing[name] - set(found[name]), f"{name} proposes without the hint: {proposing[name]}"
            helpers = [each for each in proxy.findall("Hints/InitializationHelper")
                       if each.get("class") == "vtkSMIsthmusInitialization"]
            assert helpers or not (found[name] or found.get(bases[name])), f"{name} has hints and no helper"
    return {(name, key): value for name in found
            for key, value in {**found.get(bases[name], {}), **found[name]}.items()}


def made(name, ports, given=None):
    """A filter as paraview.simple and the window make it, with a value given in the call."""
    proxy = servermanager._getPyProxy(servermanager.CreateProxy("filters", name))
    control.PreInitializeProxy(proxy)
    for port, source in ports.items():
        setattr(proxy, port, source)
    for key, value in (given or {}).items():
        proxy.SMProxy.GetProperty(key).SetElements(value)
    control.PostInitializeProxy(proxy)
    return proxy


def value_of(proxy, key):
    vector = proxy.SMProxy.GetProperty(key)
    return [vector.GetElement(i) for i in range(vector.GetNumberOfElements())]


defaults = hints()
kept, proposed = 0, 0
for name in filters():
    kind = "vtkImageData" if "vtkImageData" in kinds(name) else kinds(name)[0]
    ports, empty = {}, {}
    for port, data in inputs(name, kind).items():
        ports[port], empty[port] = producer(data), producer(data.NewInstance())
    first = made(name, ports)
    for key in first.ListProperties():
        vector = first.SMProxy.GetProperty(key)
        if vector is None or vector.GetClassName() not in NUMBERS or not vector.GetCommand() \
                or vector.GetPanelVisibility() == "never" or vector.GetInformationOnly():
            continue
        default = defaults.get((name, key))
        if default is None:
            xml = servermanager._getPyProxy(servermanager.CreateProxy("filters", name))
            default = value_of(xml, key)
        if not default:
            continue
        given = made(name, ports, {key: default})
        assert value_of(given, key) == default, f"{name}({key}={default}) has {value_of(given, key)}"
        kept += 1
        if (name, key) in defaults:
            without = made(name, empty)
            assert value_of(without, key) == default, f"{name}.{key} without data: {value_of(without, key)}"
            is_proposed = value_of(first, key) != default
            assert is_proposed != ((name, key) in NO_PROPOSAL), f"{name}.{key}: {value_of(first, key)}"
            proposed += is_proposed
print(f"{kept} defaults are kept where they are given; {proposed} of them have a proposal otherwise")
assert kept > 400 and proposed > 10

# The level is automatic also where the map had not been read when the filter was made, and stays so in a state
# file; one that is given in the call is not, also if it is 0, with a map that was read and with one that was not.


def level_of(proxy):
    simple.UpdatePipeline(proxy=proxy)
    return output_of(proxy).GetFieldData().GetArray("Level").GetValue(0)


def reloaded(proxy):
    """The proxy as a state file has it."""
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "loops.pvsm")
        simple.RenameSource("Saved", proxy)
        simple.SaveState(path)
        simple.RenameSource("Given", proxy)
        simple.LoadState(path)
    return simple.FindSource("Saved")


def wavelet():
    return simple.Wavelet(Maximum=10.0, XMag=10.0, YMag=10.0, ZMag=10.0, WholeExtent=[-4, 4, -4, 4, -4, 4])


ball = wavelet()
ball.UpdatePipeline()
low, high = ball.PointData["RTData"].GetRange()
assert low < 0 < 5 < high
of_surface = level_of(simple.MapSurface(Input=wavelet()))
for is_read in (True, False):
    for given, used in (({}, of_surface), ({"Level": 5.0}, 5.0), ({"Level": 0.5 * (low + high)}, 0.5 * (low + high)),
                        ({"Level": 0.0}, 0.0), ({"AutomaticLevel": 0, "Level": 0.0}, 0.0)):
        for make in (simple.MapSurface, simple.DualContouring):
            source = wavelet()
            if is_read:
                source.UpdatePipeline()
            made = make(Input=source, **given)
            assert level_of(made) == used, (is_read, given, level_of(made), used)
            again = reloaded(made)
            assert level_of(again) == used, (is_read, given, "in a state file", level_of(again), used)
            again.Level = 6.0
            assert level_of(again) == 6.0 and again.AutomaticLevel == 0, "set after loading"
            for each in list(simple.GetSources().values()):
                simple.Delete(each)
changed = simple.MapSurface(Input=wavelet())
changed.Level = 5.0
assert level_of(changed) == 5.0 and changed.AutomaticLevel == 0
changed.AutomaticLevel = 1
assert level_of(changed) == of_surface
