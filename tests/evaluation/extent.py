"""How much of everything an evaluation makes: in full, or to see that all of it works."""
from dataclasses import dataclass

from saliency.experiment import UNITS_PER_DATA_SET


@dataclass(frozen=True)
class Benchmark:
    """What the performance table is measured with. edge_voxels: of the phantoms in the table;
    small_edge_voxels: of those that show whether the filters' cost depends on the volume, an eighth
    of the voxels. seconds_a_case: half of it is for the stages, whose medians need some dozen
    frames."""

    phantoms: tuple = ("phantom:head", "phantom:knees", "phantom:abdomen")
    size: str = "512x512"
    edge_voxels: int = 256
    small_edge_voxels: int = 128
    least_frames: int = 200
    seconds_a_case: float = 4


@dataclass(frozen=True)
class Extent:
    """most_studied: five data sets at least give the test over them a chance (p >= 2^-5); more than
    seven do not fit the time of two cores. units: of a data set. sheet_px: width and height of a
    picture of the gallery. study_px: side of one of the study."""

    phantoms: tuple = ("phantom:head", "phantom:abdomen", "phantom:knees")
    most_studied: int = 7
    units: int = UNITS_PER_DATA_SET
    sheet_px: tuple = (400, 360)
    study_px: int = 768
    style_px: tuple = (480, 360)
    most_styles: int | None = None
    benchmark: Benchmark = Benchmark()
    is_quick: bool = False


FULL = Extent()
QUICK = Extent(
    phantoms=("phantom:head@96",),
    units=3,
    sheet_px=(160, 144),
    study_px=256,
    most_styles=2,
    benchmark=Benchmark(
        phantoms=("phantom:head",),
        size="128x128",
        edge_voxels=64,
        small_edge_voxels=32,
        least_frames=12,
        seconds_a_case=0.2,
    ),
    is_quick=True,
)
