"""Finds landmarks in a folder of photos with Dask: python dask_landmarks.py FOLDER TABLE.parquet"""

import sys
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet
import rosto
from distributed import Client


def of_chunk(paths: list[str]) -> pa.Table:
    table = rosto.landmarks(paths, rosto.Search(mediapipe=True)).to_arrow()
    return table.add_column(0, "path", pa.array(paths))


def landmarks(client: Client, paths: list[str], chunk_size: int = 25) -> pa.Table:
    chunks = [paths[start : start + chunk_size] for start in range(0, len(paths), chunk_size)]
    return pa.concat_tables(client.gather(client.map(of_chunk, chunks)))


if __name__ == "__main__":
    with Client() as client:
        photos = sorted(str(path) for path in Path(sys.argv[1]).iterdir())
        pyarrow.parquet.write_table(landmarks(client, photos), sys.argv[2])
