#!/usr/bin/python3
"""Writes random direction pairs for `gonio evaluate --pairs`: make_pairs.py COUNT SEED OUT.npy

wi is uniform over the upper hemisphere. Half of the wo are uniform too; the other half lie around the mirror direction of
wi, where a metal's lobe is. The file is COUNT x 6 float32: wi_x, wi_y, wi_z, wo_x, wo_y, wo_z.
"""

import sys

import numpy as np


def hemisphere(rng, count):
    z = rng.uniform(0.01, 1, count)
    phi = rng.uniform(0, 2 * np.pi, count)
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], axis=1)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    count, seed, out = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
    rng = np.random.default_rng(seed)
    wi, wo = hemisphere(rng, count), hemisphere(rng, count)
    mirror = wi * [-1, -1, 1] + rng.normal(0, 0.1, wi.shape)
    mirror[:, 2] = np.maximum(np.abs(mirror[:, 2]), 0.01)
    near = rng.random(count) < 0.5
    wo[near] = mirror[near]
    wo /= np.linalg.norm(wo, axis=1, keepdims=True)
    np.save(out, np.hstack([wi, wo]).astype(np.float32))


if __name__ == "__main__":
    main()
