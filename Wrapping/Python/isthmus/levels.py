"""The values of a map for the panel of a level: histogram, useful range, standard deviations and enclosed volume.

    from isthmus import levels                    # or: from isthmus_plugin, with the plugin loaded
    levels.describe(surface, "Density")           # surface: a Map Surface whose result is up to date
"""

try:
    from paraview import servermanager
except ImportError:
    servermanager = None  # with pip's vtk alone, isthmus.pipelines can still be imported

BINS = 8192  # over all values
BARS = 120  # over the useful range
NOISE = 2.0  # standard deviations of the background above which the useful range begins
TOP = 0.001  # share of the values inside the automatic level that may lie above the useful range
PROTEIN = 0.81  # dalton per cubic angstrom, at 1.35 g/cm^3

_known = {}  # counts by (global id of the source, port, array, time of modification)


def describe(surface, array):
    """None for a group of maps or a constant map. Otherwise a dictionary: `low` and `high` of the useful range, `bars` (numbers of
    nodes in equal parts of it), `inside` (volume that each of their lower ends encloses, in cubic units of length),
    `mean` and `deviation` of all values, `automatic` (level) and `source` (of that level), `protein` (dalton for a unit
    of volume; 0 where the values are no density).

    The range begins at the noise, i.e. NOISE standard deviations above the most frequent value, where the deviation is
    that of the values below it; it ends below the top TOP of the values inside the automatic level, and contains that
    level."""
    port = surface.Input
    counted = _counts(port, array)
    if counted is None:
        return None
    (low, high), counts = counted
    is_higher = bool(surface.InsideIsHigher)
    if not is_higher:
        low, high, counts = -high, -low, counts[::-1]  # of the negative values
    width = (high - low) / len(counts)
    values = [low + (i + 0.5) * width for i in range(len(counts))]
    number = sum(counts)
    mean = sum(n * value for n, value in zip(counts, values)) / number
    deviation = (sum(n * (value - mean) ** 2 for n, value in zip(counts, values)) / number) ** 0.5
    field = surface.FieldData["AutomaticLevel"]
    sign = 1.0 if is_higher else -1.0
    automatic = sign * field.GetRange(0)[0] if field else None
    begin, end = _useful(values, counts, width, mean if automatic is None else automatic)
    above = _sums_from_top(counts)
    volume = _volume_of_node(port)
    edges = [begin + (end - begin) * i / BARS for i in range(BARS + 1)]
    inside = [_at(above, (edge - low) / width) * volume for edge in edges]
    return {"low": sign * (begin if is_higher else end), "high": sign * (end if is_higher else begin),
            "bars": [(lower - upper) / volume for lower, upper in zip(inside, inside[1:])][::1 if is_higher else -1],
            "inside": inside[::1 if is_higher else -1], "mean": sign * mean, "deviation": deviation,
            "automatic": None if automatic is None else sign * automatic, "source": _text(surface, "AutomaticLevelSource"),
            "protein": PROTEIN if array == "Density" else 0.0}


def _counts(port, array):
    information = port.GetDataInformation()
    found = port.PointData[array]
    if found is None or information.DataInformation.GetCompositeDataSetType() != -1:
        return None
    low, high = found.GetRange(0)
    if not low < high or high - low == float("inf"):
        return None
    proxy = port.SMProxy
    key = (proxy.GetGlobalID(), port.Port, array, information.DataInformation.GetMTime())
    if key not in _known:
        _known.clear()  # those of the last map are enough
        histogram = servermanager.filters.Histogram(
            Input=port, SelectInputArray=["POINTS", array], BinCount=BINS, UseCustomBinRanges=1, CustomBinRanges=[low, high])
        histogram.UpdatePipeline()
        column = servermanager.Fetch(histogram).GetRowData().GetArray("bin_values")
        _known[key] = [column.GetTuple1(i) for i in range(column.GetNumberOfTuples())]
    return (low, high), _known[key]


def _useful(values, counts, width, automatic):
    """Range from the noise to the maximum of what is inside the automatic level."""
    mode = max(range(len(counts)), key=counts.__getitem__)
    below = sum(counts[:mode])
    spread = (sum(n * (value - values[mode]) ** 2 for n, value in zip(counts[:mode], values)) / below) ** 0.5 if below else 0.0
    begin = values[mode] + NOISE * spread
    if begin >= automatic:
        begin = min(values[mode], automatic - 2.0 * width)
    inside = sum(n for n, value in zip(counts, values) if value > automatic)
    rest, top = TOP * inside, len(counts) - 1
    while top > 0 and rest >= counts[top] and values[top] > automatic:
        rest -= counts[top]
        top -= 1
    return begin, max(values[top] + 0.5 * width, automatic + 2.0 * width)


def _sums_from_top(counts):
    sums, total = [0.0], 0.0
    for count in reversed(counts):
        total += count
        sums.append(total)
    return sums[::-1]


def _at(sums, place):
    place = min(max(place, 0.0), len(sums) - 1.0)
    first = min(int(place), len(sums) - 2)
    return sums[first] + (place - first) * (sums[first + 1] - sums[first])


def _volume_of_node(port):
    information = port.GetDataInformation().DataInformation
    extent, bounds, volume = information.GetExtent(), information.GetBounds(), 1.0
    for axis in range(3):
        steps = extent[2 * axis + 1] - extent[2 * axis]
        volume *= (bounds[2 * axis + 1] - bounds[2 * axis]) / steps if steps else 1.0
    return volume


def _text(source, name):
    information = source.SMProxy.GetDataInformation(0).GetFieldDataInformation().GetArrayInformation(name)
    return information.GetStringValue(0) if information else ""
