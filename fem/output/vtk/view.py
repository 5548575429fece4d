"""Opens the series beside this file in ParaView as it is meant to be looked at, and plays it.

    paraview --script=view.py                         on the screen
    pvpython view.py --save picture.png               a picture of the frame that tells most
    pvpython view.py --save picture.png --frame 12    of frame 12, from 0
    pvpython view.py --colour bending_stress_MPa      by another array
    xvfb-run -a pvpython view.py --save picture.png   without a screen

Colours mean the same in every frame: their scale is that of the whole run.
"""

import argparse
import os
import sys

import paraview.simple
from paraview.simple import *  # ParaView's own way

# CONSTANTS

# Roles of bodies, and the colours of those that have no field.
WORK, MACHINE, TOOL, FORCE, NOMINAL = range(5)
COLOURS = {
    MACHINE: (0.62, 0.64, 0.67),
    TOOL: (0.93, 0.69, 0.13),
    FORCE: (0.80, 0.16, 0.30),
    NOMINAL: (0.35, 0.37, 0.40),
}
INK = (0.13, 0.13, 0.15)
# From the middle of the picture to the eye.
DIRECTION = (0.0, 0.0, 1.0) if FROM_THE_FRONT else (0.20, 0.36, 0.91)


def folder():
    """The folder of this script; ParaView's GUI does not always say."""
    try:
        return os.path.dirname(os.path.abspath(__file__))
    except NameError:
        pass
    for argument in sys.argv:
        if argument.startswith("--script="):
            return os.path.dirname(os.path.abspath(argument[len("--script="):]))
    return os.getcwd()


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--save", metavar="PICTURE.png", help="save a picture and end")
    parser.add_argument("--frame", type=int, default=TELLING_FRAME, help="frame of the picture, from 0")
    parser.add_argument("--colour", default=SHOWN, choices=sorted(RANGES) or None, help="array that colours the work")
    parser.add_argument("--size", default="1280x760", help="of the picture, in pixels")
    return parser.parse_known_args()[0]


def having(role, source):
    """The bodies of a role."""
    found = Threshold(Input=source)
    found.Scalars = ["CELLS", "role"]
    try:
        found.LowerThreshold, found.UpperThreshold = role, role
    except AttributeError:  # before ParaView 5.10
        found.ThresholdRange = [role, role]
    return found


def smooth(source):
    """The surface with normals, so that round bodies look round and edges stay sharp."""
    surface = ExtractSurface(Input=source)
    normals = globals().get("GenerateSurfaceNormals") or globals()["SurfaceNormals"]
    return normals(Input=surface, FeatureAngle=40.0)


def words(array):
    """`bending_stress_MPa` as people read it: ('bending stress', 'MPa')."""
    name, _, unit = array.rpartition("_")
    return (name or unit).replace("_", " "), unit if name else ""


def write(text, view, corner, size):
    """Writes a text into the picture."""
    shown = Show(text, view, "TextSourceRepresentation")
    shown.WindowLocation = corner
    shown.FontSize, shown.Color, shown.FontFamily = size, INK, "Arial"
    return shown


def note(sentence, view, corner, size):
    text = Text()
    text.Text = sentence
    return write(text, view, corner, size)


def plain(shown):
    """Takes the colours of an array away."""
    shown.ColorArrayName = [None, ""]


def colour(shown, array, view):
    """Colours by an array on its scale for the whole run."""
    low, high = RANGES[array]
    if high <= low:
        low, high = low - 0.5, high + 0.5
    ColorBy(shown, ("POINTS", array))
    scale = GetColorTransferFunction(array)
    both = low < 0.0 < high
    warm = array.endswith("_degC") or array.endswith("_K")
    name = "Cool to Warm" if both else "Inferno (matplotlib)" if warm else "Viridis (matplotlib)"
    scale.ApplyPreset(name, True)
    scale.RescaleTransferFunction(low, high)
    scale.AutomaticRescaleRangeMode = "Never"
    bar = GetScalarBar(scale, view)
    bar.Title, bar.ComponentTitle = ", ".join(filter(None, words(array))), ""
    bar.TitleColor = bar.LabelColor = INK
    bar.TitleFontSize, bar.LabelFontSize = 20, 18
    bar.Orientation, bar.WindowLocation, bar.ScalarBarLength = "Vertical", "Lower Right Corner", 0.5
    bar.LabelFormat = bar.RangeLabelFormat = "%.4g"
    bar.ScalarBarThickness = 20
    shown.SetScalarBarVisibility(view, True)


def bounds_of_all(source, times):
    """What the frames fill, all together."""
    box = None
    for time in times[:: max(1, len(times) // 8)] + times[-1:]:
        source.UpdatePipeline(time)
        own = source.GetDataInformation().GetBounds()
        box = own if box is None else [
            pick(a, b) for a, b, pick in zip(box, own, (min, max) * 3)
        ]
    return box


def look(view, box):
    """Looks at a box from the front, a little from above and from the right."""
    middle = [0.5 * (box[i] + box[i + 1]) for i in (0, 2, 4)]
    size = [box[i + 1] - box[i] for i in (0, 2, 4)]
    across = size[0] + size[2] * DIRECTION[0]
    upright = size[1] + size[0] * DIRECTION[0] * DIRECTION[1] + size[2] * DIRECTION[1]
    # The legend has the right edge.
    middle[0] += 0.05 * across
    far = 4.0 * max(sum(s * s for s in size) ** 0.5, 1e-9)
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + far * d for m, d in zip(middle, DIRECTION)]
    view.CameraViewUp = [0.0, 1.0, 0.0]
    # Half of the height that is seen; the legends take the edges.
    wide, high = view.ViewSize
    view.CameraParallelScale = max(0.5 * upright / 0.66, 0.5 * across / 0.68 * high / wide)


def main():
    asked = arguments()
    paraview.simple._DisableFirstRenderCameraReset()
    series = PVDReader(registrationName=SERIES, FileName=os.path.join(folder(), SERIES))
    times = list(series.TimestepValues) if hasattr(series.TimestepValues, "__len__") else [series.TimestepValues]
    view = GetActiveViewOrCreate("RenderView")
    if asked.save:
        view.ViewSize = [int(side) for side in asked.size.split("x")]
    for name, value in (("UseColorPaletteForBackground", 0), ("Background", [1.0, 1.0, 1.0])):
        if hasattr(view, name):
            setattr(view, name, value)
    view.OrientationAxesVisibility = 1
    view.OrientationAxesLabelColor = INK
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = times[min(asked.frame, len(times) - 1)] if asked.save else times[0]

    work = having(WORK, series)
    shown = Show(smooth(work), view)
    if asked.colour in RANGES:
        colour(shown, asked.colour, view)
    shown.Interpolation, shown.Ambient, shown.Diffuse, shown.Specular = "Gouraud", 0.3, 0.8, 0.05
    for role, tint in COLOURS.items():
        body = Show(smooth(having(role, series)), view)
        plain(body)
        body.AmbientColor = body.DiffuseColor = tint
        body.Ambient, body.Diffuse = 0.3, 0.8
        if role == NOMINAL:
            body.Opacity = 0.6
    box = bounds_of_all(work, times)
    look(view, box)
    if not FROM_THE_FRONT:
        # Where the work would be without any displacement, a hair behind what it may coincide with.
        still = WarpByVector(Input=work)
        still.Vectors, still.ScaleFactor = ["POINTS", "displacement_magnified"], -1.0
        ghost = Show(smooth(still), view)
        plain(ghost)
        ghost.AmbientColor = ghost.DiffuseColor = (0.45, 0.5, 0.56)
        ghost.Opacity = 0.16
        hair = 0.004 * max(box[i + 1] - box[i] for i in (0, 2, 4))
        ghost.Position = [-hair * d for d in DIRECTION]

    # A long title stays clear of what stands in the other corner.
    note(TITLE, view, "Upper Left Corner", 26 if len(TITLE) < 36 else 20)
    told = f"displacements magnified {MAGNIFICATION:,.6g} times".replace(",", " ")
    if MAGNIFICATION == 1.0:
        told = "displacements to scale"
    if LARGEST_FORCE_N > 0.0:
        told += f"\nred: forces, the longest {LARGEST_FORCE_N:.4g} N"
    note(told, view, "Upper Right Corner", 20).Justification = "Right"
    caption = AnnotateAttributeData(Input=series)
    caption.SelectInputArray = ["FIELD", "caption"]
    caption.Prefix = ""
    write(caption, view, "Lower Center", 22)
    Render(view)
    if asked.save:
        SaveScreenshot(asked.save, view, ImageResolution=view.ViewSize, CompressionLevel="9")
    print(f"{MODEL}: {told.splitlines()[0]}; written by {VERSION}; time is {TIME}")


main()
