"""Finds landmarks in a folder of photos with Ray Data: python ray_landmarks.py FOLDER TABLES"""

import sys

import ray
import rosto


def with_landmarks(photos: dict) -> dict:
    found = rosto.landmarks(photos["bytes"], rosto.Search(mediapipe=True))
    return {"path": photos["path"], "points": found.points, "confidence": found.confidence, "reason": found.reasons}


def landmarks(folder: str) -> "ray.data.Dataset":
    return ray.data.read_binary_files(folder, include_paths=True).map_batches(with_landmarks, batch_size=25)


if __name__ == "__main__":
    landmarks(sys.argv[1]).write_parquet(sys.argv[2])
