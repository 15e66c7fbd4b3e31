"""Writes crates/photo/tests/fixtures: small JPEG files with many sampling factors and scan orders.

Uses cjpeg and djpeg of libjpeg-turbo 2.1.5 (Debian's libjpeg-turbo-progs). Each entry of libjpeg.bin consists of a byte
with the length of the name, the name, the length of the file (u32, big-endian), the file, and the CRC-32 of the RGB
pixels that djpeg decodes (u32, big-endian). Also writes the files of the damage tests: one upright picture as baseline
JPEG, as progressive JPEG, and with restart intervals.
"""

import itertools
import math
import random
import struct
import subprocess
import tempfile
import zlib
from pathlib import Path

FIXTURES = Path(__file__).parents[2] / "crates/photo/tests/fixtures"
SIZES_PX = [(1, 1), (17, 31), (33, 9), (2, 17), (7, 40), (40, 3), (16, 16), (9, 8)]
# Scan scripts of cjpeg: components; for progressive files also Ss-Se, Ah, Al.
ONE_EACH = "0; 1; 2;"
PROGRESSIVE_ONE_EACH = (
    "0: 0-0, 0, 0; 1: 0-0, 0, 0; 2: 0-0, 0, 0; 2: 1-63, 0, 0; 0: 1-5, 0, 2; 0: 6-63, 0, 2; 0: 1-63, 2, 1;"
    " 0: 1-63, 1, 0; 1: 1-63, 0, 0;"
)
SCANS = [
    ONE_EACH,
    "2; 1; 0;",
    "0,1; 2;",
    "1; 0,2;",
    "0,1,2;",
    "0,1,2: 0-0, 0, 0; 0: 1-63, 0, 0; 1: 1-63, 0, 0; 2: 1-63, 0, 0;",
    PROGRESSIVE_ONE_EACH,
    "0,1,2: 0-0, 0, 1; 0: 1-5, 0, 2; 2: 1-63, 0, 1; 1: 1-63, 0, 1; 0: 6-63, 0, 2; 0: 1-63, 2, 1; 0,1,2: 0-0, 1, 0;"
    " 2: 1-63, 1, 0; 1: 1-63, 1, 0; 0: 1-63, 1, 0;",
    "0,1: 0-0, 0, 0; 0: 1-63, 0, 0; 2: 0-0, 0, 0; 1: 1-63, 0, 0; 2: 1-63, 0, 0;",
]
RESTARTS = [[], ["-restart", "1"], ["-restart", "2B"]]


def picture(width, height):
    chance = random.Random(1000 * width + height)

    def sample(x, y, channel):
        wave = math.sin(0.35 * x * (channel + 1) + 0.2 * y * (3 - channel) + channel)
        return round(min(max(127 + 90 * wave + chance.uniform(-20, 20), 0), 255))

    samples = (sample(x, y, c) for y in range(height) for x in range(width) for c in range(3))
    return b"P6 %d %d 255\n" % (width, height) + bytes(samples)


def encoded(size_px, sampling, scans, options):
    """Returns the JPEG file, or b"" if an MCU would have more than ten blocks."""
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
        file.write(scans or "")
        file.flush()
        order = ["-scans", file.name] if scans else ["-grayscale"] if len(sampling) == 1 else []
        command = ["cjpeg", "-quality", "75", "-optimize", "-sample", listed(sampling), *order, *options]
        return subprocess.run(command, input=picture(*size_px), capture_output=True).stdout


def listed(sampling):
    return ",".join(f"{h}x{v}" for h, v in sampling)


def entry(name, file):
    pnm = subprocess.run(["djpeg", "-pnm"], input=file, capture_output=True, check=True).stdout
    kind, _, _, pixels = pnm.split(maxsplit=3)
    pixels = pixels.split(b"\n", 1)[1]
    rgb = bytes(sample for grey in pixels for sample in [grey] * 3) if kind == b"P5" else pixels
    return struct.pack(">B", len(name)) + name.encode() + struct.pack(">I", len(file)) + file + struct.pack(">I", zlib.crc32(rgb))


def divides(factors):
    return all(max(axis) % factor == 0 for axis in zip(*factors) for factor in axis)


def cases():
    chance = random.Random(1)
    factors = list(itertools.product(range(1, 5), repeat=2))
    samplings = [[luma, chroma, chroma] for luma, chroma in itertools.product(factors, repeat=2)]
    samplings += [[chance.choice(factors) for _ in range(3)] for _ in range(60)]
    usual = [[luma, (1, 1), (1, 1)] for luma in [(1, 1), (2, 1), (1, 2), (2, 2)]]
    cases = [(sampling, chance.choice(SCANS)) for sampling in filter(divides, samplings)]
    cases += itertools.product(usual, SCANS)
    for index, (sampling, scans) in enumerate(cases):
        yield SIZES_PX[index % len(SIZES_PX)], sampling, scans, chance.choice(RESTARTS)
    for size_px, options in itertools.product(SIZES_PX, [[], ["-progressive"], ["-restart", "1"]]):
        yield size_px, [(2, 2)], None, options


def main():
    packed = []
    for size_px, sampling, scans, options in cases():
        file = encoded(size_px, sampling, scans, options)
        if not file:
            scans = PROGRESSIVE_ONE_EACH if ":" in scans else ONE_EACH
            file = encoded(size_px, sampling, scans, options)
        name = " ".join([f"{size_px[0]}x{size_px[1]} px", listed(sampling), scans or "grey", *options])
        packed.append(entry(name, file))
    (FIXTURES / "libjpeg.bin").write_bytes(b"".join(packed))
    print(len(packed), "files packed")
    for name, options in [("baseline", []), ("progressive", ["-progressive"]), ("restarts", ["-restart", "1"])]:
        file = encoded((96, 384), [(2, 2), (1, 1), (1, 1)], "0,1,2;" if name != "progressive" else None, options)
        (FIXTURES / f"whole-{name}.jpg").write_bytes(file)


main()
