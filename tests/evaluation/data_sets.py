"""What a data folder holds for the evaluation: its CTs."""
import json
import subprocess

CT_UNITS = "HU"


def cts(cutaway, folder):
    """Ids of the folder's CTs as the server lists them, in its order, and of what is none. Files of
    many formats name no modality, so each is read: only values in Hounsfield units make a CT."""
    told = subprocess.run([cutaway, "info", "--json", folder], stdout=subprocess.PIPE, check=True)
    volumes = json.loads(told.stdout)["volumes"]
    found = [volume["id"] for volume in volumes if volume["units"] == CT_UNITS]
    return found, [volume["id"] for volume in volumes if volume["id"] not in found]
