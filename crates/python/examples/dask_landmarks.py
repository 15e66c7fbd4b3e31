"""Landmarks of all photos in a folder by Dask, on one machine or on many: python dask_landmarks.py FOLDER TABLE.parquet"""

import sys
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet
import rosto
from distributed import Client


def of_some(paths: list[str]) -> pa.Table:
    table = rosto.landmarks(paths, rosto.Search(mediapipe=True)).to_arrow()
    return table.add_column(0, "path", pa.array(paths))


def landmarks(client: Client, paths: list[str], at_a_time: int = 25) -> pa.Table:
    some = [paths[start : start + at_a_time] for start in range(0, len(paths), at_a_time)]
    return pa.concat_tables(client.gather(client.map(of_some, some)))


if __name__ == "__main__":
    with Client() as client:
        photos = sorted(str(path) for path in Path(sys.argv[1]).iterdir())
        pyarrow.parquet.write_table(landmarks(client, photos), sys.argv[2])
