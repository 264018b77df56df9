"""What a data folder holds for the evaluation: its CTs, and all that has more than one surface."""
import json
import subprocess

CT_UNITS = "HU"
# As `cutaway info` calls them: their focus is their context's own surface, and a lens has nothing
# to show.
ONE_SURFACE = ("two values (a mask)", "labels", "one value", "noise")


def read(cutaway, folder):
    """The folder's volumes as the server lists them, in its order. Files of many formats name no
    modality, so each is read."""
    told = subprocess.run([cutaway, "info", "--json", folder], stdout=subprocess.PIPE, check=True)
    return json.loads(told.stdout)["volumes"]


def cts(volumes):
    """Ids of the CTs and of what is none: only values in Hounsfield units make a CT."""
    found = [volume["id"] for volume in volumes if volume["units"] == CT_UNITS]
    return found, [volume["id"] for volume in volumes if volume["id"] not in found]


def with_two_surfaces(volumes):
    """Ids of those that can have a focus within a context."""
    return [v["id"] for v in volumes if v["first_look"]["kind"] not in ONE_SURFACE]
