"""How long VTK's volume mappers take for the same work as Cutaway, in the same run, turn by turn.

Each round times Cutaway's control (an iso-surface under Phong light) and flagship, then VTK's mappers: same volume,
camera, picture size and sampling distance, the camera turning by a degree a frame. Reported are medians over the
rounds, ratios within each round, and how well VTK's silhouettes agree with Cutaway's, as proof that the work is the same.

Usage: yardstick.py CUTAWAY_BENCHMARK OUT.json [--volume PART_OF_NAME] [--data DIR] [--size WIDTHxHEIGHT] [--rounds N]
       on a display that has OpenGL (tests/benchmark/yardstick starts one)
"""

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

CONTROL, FLAGSHIP = "Phong, no lens", "flagship"
FRAMES = {"fixed point": 12, "GPU composite": 3, "GPU iso-surface": 3}


class Task:
    """What Cutaway drew: see yardstick_task.h."""

    def __init__(self, folder):
        self.fields = json.loads((folder / "task.json").read_text())
        self.voxels = np.fromfile(folder / "voxels.raw", "<i2")
        width, height = self.fields["size_px"]
        self.silhouette = np.fromfile(folder / "silhouette.raw", np.uint8).reshape(height, width) > 0

    def image(self):
        image = vtk.vtkImageData()
        image.SetDimensions(self.fields["size_voxels"])
        image.SetSpacing(self.fields["spacing_mm"])
        image.SetOrigin(self.fields["origin_mm"])
        image.GetPointData().SetScalars(numpy_to_vtk(self.voxels, deep=True, array_type=vtk.VTK_SHORT))
        return image

    def placement(self):
        """The mappers of VTK 9.1 place their boxes along the axes: the volume's matrix turns them about the origin."""
        direction = np.array(self.fields["direction"]).reshape(3, 3)
        origin = np.array(self.fields["origin_mm"])
        matrix = vtk.vtkMatrix4x4()
        for row in range(3):
            for column in range(3):
                matrix.SetElement(row, column, direction[row, column])
            matrix.SetElement(row, 3, (origin - direction @ origin)[row])
        return matrix


def opaque_from(iso_value):
    """Nothing below the iso-value, opaque above: a composite stops at the surface."""
    opacity = vtk.vtkPiecewiseFunction()
    opacity.AddPoint(iso_value - 0.5, 0.0)
    opacity.AddPoint(iso_value + 0.5, 1.0)
    colour = vtk.vtkColorTransferFunction()
    colour.AddRGBPoint(0.0, 0.8, 0.62, 0.52)
    material = vtk.vtkVolumeProperty()
    material.SetScalarOpacity(opacity)
    material.SetColor(colour)
    material.SetInterpolationTypeToLinear()
    material.ShadeOn()
    return material


def fixed_point(task):
    mapper = vtk.vtkFixedPointVolumeRayCastMapper()
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetImageSampleDistance(1.0)
    mapper.SetSampleDistance(task.fields["step_mm"])
    mapper.SetInteractiveSampleDistance(task.fields["step_mm"])
    return mapper


def gpu(task, is_iso_surface):
    mapper = vtk.vtkGPUVolumeRayCastMapper()
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetImageSampleDistance(1.0)
    mapper.SetSampleDistance(task.fields["step_mm"])
    if is_iso_surface:
        mapper.SetBlendModeToIsoSurface()
    return mapper


class Mapper:
    """One of VTK's mappers in a window of its own."""

    def __init__(self, name, task):
        self.name, self.task, self.frames_drawn = name, task, 0
        mapper = fixed_point(task) if name == "fixed point" else gpu(task, name == "GPU iso-surface")
        mapper.SetInputData(task.image())
        material = opaque_from(task.fields["iso_value"])
        if name == "GPU iso-surface":
            material.GetIsoSurfaceValues().SetValue(0, task.fields["iso_value"])
            material.GetScalarOpacity().AddPoint(task.fields["iso_value"], 1.0)
        volume = vtk.vtkVolume()
        volume.SetMapper(mapper)
        volume.SetProperty(material)
        volume.SetUserMatrix(task.placement())
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(0.0, 0.0, 1.0)
        self.renderer.AddVolume(volume)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(task.fields["size_px"])
        self.window.AddRenderer(self.renderer)
        self.draw(0)  # compiles and uploads
        self.agreement = self.overlap()

    def draw(self, degrees):
        fields, camera = self.task.fields, self.renderer.GetActiveCamera()
        target = np.array(fields["target_mm"])
        arm = np.array(fields["eye_mm"]) - target
        turn = np.radians(degrees)
        turned = [arm[0] * np.cos(turn) - arm[1] * np.sin(turn), arm[0] * np.sin(turn) + arm[1] * np.cos(turn), arm[2]]
        camera.SetPosition(*(target + turned))
        camera.SetFocalPoint(*target)
        camera.SetViewUp(*fields["up"])
        camera.SetViewAngle(fields["vertical_fov_degrees"])
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        self.window.WaitForCompletion()

    def picture(self):
        grabber = vtk.vtkWindowToImageFilter()
        grabber.SetInput(self.window)
        grabber.ReadFrontBufferOff()
        grabber.Update()
        image = grabber.GetOutput()
        width, height, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]

    def overlap(self):
        """Intersection over union of the silhouettes from the front."""
        drawn = np.abs(self.picture().astype(int) - [0, 0, 255]).sum(axis=2) > 30
        both, either = drawn & self.task.silhouette, drawn | self.task.silhouette
        return both.sum() / either.sum()

    def median_ms(self):
        times = []
        for _ in range(FRAMES[self.name]):
            self.frames_drawn += 1
            begun = time.perf_counter()
            self.draw(self.frames_drawn)
            times.append(1000 * (time.perf_counter() - begun))
        return statistics.median(times)

    def gl_renderer(self):
        report = self.window.ReportCapabilities() or ""
        return next((line.split(":", 1)[1].strip() for line in report.splitlines() if "renderer string" in line), "?")


def cutaway_round(options, folder):
    """Median milliseconds of Cutaway's cases; leaves the task in the folder."""
    figures = folder / "cutaway.json"
    command = [options.benchmark, "--volumes", options.volume, "--sizes", options.size, "--cases", CONTROL, FLAGSHIP,
               "--seconds", "4", "--json", figures, "--write-task", folder]  # fmt: skip
    if options.data:
        command += ["--data", options.data]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    report = json.loads(figures.read_text())
    return report["machine"], {frame["case"]: frame["median_ms"] for frame in report["frames"]}


def measure(options):
    rounds, mappers, machine = [], [], {}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for number in range(options.rounds):
            print(f"round {number + 1} of {options.rounds}", file=sys.stderr)
            machine, times = cutaway_round(options, folder)
            mappers = mappers or [Mapper(each, Task(folder)) for each in FRAMES]
            rounds.append(times | {mapper.name: mapper.median_ms() for mapper in mappers})
    return machine, rounds, mappers


def report(options, machine, rounds, mappers):
    rows = {CONTROL: None, FLAGSHIP: None} | {mapper.name: mapper.agreement for mapper in mappers}
    result = []
    for name, agreement in rows.items():
        ratios = [each[name] / each[CONTROL] for each in rounds]
        result.append({
            "name": name, "median_ms": statistics.median(each[name] for each in rounds),
            "times_control": statistics.median(ratios), "ratios": ratios, "silhouette_overlap": agreement,
        })  # fmt: skip
    return {
        "machine": machine, "volume": options.volume, "size": options.size, "vtk": vtk.vtkVersion.GetVTKVersion(),
        "vtk_renderer": mappers[-1].gl_renderer(), "rounds": len(rounds), "rows": result,
    }  # fmt: skip


def table(figures):
    print(f"{figures['machine']['processor']}, {figures['machine']['cores']} cores; {figures['machine']['renderer']}")
    print(f"VTK {figures['vtk']} on {figures['vtk_renderer']}; {figures['volume']}, {figures['size']}")
    print(f"{'':24}{'median ms':>10}{'x control':>11}   silhouette")
    for row in figures["rows"]:
        overlap = "" if row["silhouette_overlap"] is None else f"{100 * row['silhouette_overlap']:.2f} % the same"
        print(f"{row['name']:24}{row['median_ms']:10.1f}{row['times_control']:11.2f}   {overlap}")


def main():
    parser = argparse.ArgumentParser(description="Cutaway beside VTK's volume mappers")
    parser.add_argument("benchmark")
    parser.add_argument("json", type=Path)
    parser.add_argument("--volume", default="phantom:head")
    parser.add_argument("--data")
    parser.add_argument("--size", default="512x512")
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    figures = report(options, *measure(options))
    table(figures)
    options.json.write_text(json.dumps(figures, indent=2) + "\n")


if __name__ == "__main__":
    main()
