"""What a proxy of this process has made: its output data, and the times of choking loops' stages. (A
programmable source takes the name `output` from the script that made it.)"""

from paraview import servermanager


def output_of(proxy, port=0):
    """Fetch() of ParaView 5.11 gives port 0 whatever it is asked for."""
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def stage_times(loops):
    loops.UpdatePropertyInformation()  # the property is not part of the panel
    times = servermanager.vtkSMPropertyHelper(loops.SMProxy, "StageTimes")
    return [times.GetAsDouble(stage) for stage in range(5)]
