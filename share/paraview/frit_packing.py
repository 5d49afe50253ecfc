"""Shows the result of a frit run in ParaView: spheres to scale, the contact network (hidden at first), the time.

In ParaView: Macros > Import new macro, this file; open a result's snapshots.pvd, select it, run the macro.
From a shell: pvpython frit_packing.py RESULT/snapshots.pvd [PICTURE.png [ARRAY]]     the last snapshot as a picture
"""
import os
import sys

from paraview import simple

ARRAY = "coordination"  # colours the spheres


def add_spheres(collection, array, view):
    """The particles as spheres of their own radii, coloured by one of their arrays."""
    particles = simple.ExtractBlock(registrationName="particles", Input=collection, Selectors=["/Root/particles"])
    spheres = simple.Glyph(registrationName="spheres", Input=particles, GlyphType="Sphere")
    spheres.GlyphType.Radius = 1.0
    spheres.GlyphType.ThetaResolution = 24
    spheres.GlyphType.PhiResolution = 16
    spheres.ScaleArray = ["POINTS", "radius"]
    spheres.ScaleFactor = 1.0
    spheres.OrientationArray = ["POINTS", "No orientation array"]
    spheres.GlyphMode = "All Points"
    shown = simple.Show(spheres, view)
    simple.ColorBy(shown, ("POINTS", array))
    shown.RescaleTransferFunctionToDataRange(False)
    shown.SetScalarBarVisibility(view, True)
    return spheres


def add_contacts(collection, view):
    """The contact network as lines from centre to centre, hidden at first."""
    contacts = simple.ExtractBlock(registrationName="contacts", Input=collection, Selectors=["/Root/contacts"])
    simple.Show(contacts, view).LineWidth = 2.0
    simple.Hide(contacts, view)
    return contacts


def show(collection, array=ARRAY):
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.Hide(collection, view)
    spheres = add_spheres(collection, array, view)
    contacts = add_contacts(collection, view)
    simple.AnnotateTimeFilter(registrationName="time", Input=collection, Format="t = {time:.4g} s")
    simple.Show(simple.GetActiveSource(), view)
    view.OrientationAxesVisibility = 1
    simple.ResetCamera(view)
    simple.SetActiveSource(spheres)
    simple.Render(view)
    return spheres, contacts, view


def main(arguments):
    collection = simple.PVDReader(registrationName="snapshots", FileName=os.path.abspath(arguments[0]))
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().GoToLast()
    view = show(collection, *arguments[2:3])[2]
    if len(arguments) > 1:
        simple.SaveScreenshot(arguments[1], view, ImageResolution=[1600, 1200])


if __name__ == "__main__" and len(sys.argv) > 1:
    main(sys.argv[1:])
elif __name__ == "__main__" and simple.GetActiveSource() is not None:  # as a macro
    show(simple.GetActiveSource())
