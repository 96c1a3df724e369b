#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Independent results for metrics_test.cpp, printed as JSON.

png TEST REFERENCE   PSNR and SSIM by scikit-image of two 8-bit PNG files, values / 255; MS-SSIM from SciPy filters
exr FILE             content of an OpenEXR file read by OpenImageIO
"""
import json
import sys

import imageio
import numpy
import OpenImageIO
from scipy.ndimage import gaussian_filter
from skimage.metrics import peak_signal_noise_ratio, structural_similarity


def ms_ssim_of_channel(x, r):
    result = 1.0
    for scale, weight in enumerate([0.0448, 0.2856, 0.3001, 0.2363, 0.1333]):
        if scale > 0:
            x, r = [a[: a.shape[0] // 2 * 2, : a.shape[1] // 2 * 2] for a in (x, r)]
            x, r = [a.reshape(a.shape[0] // 2, 2, a.shape[1] // 2, 2).mean(axis=(1, 3)) for a in (x, r)]
        blur = lambda a: gaussian_filter(a, 1.5, truncate=3.5)[5:-5, 5:-5]
        mx, mr = blur(x), blur(r)
        vx, vr, cov = blur(x * x) - mx * mx, blur(r * r) - mr * mr, blur(x * r) - mx * mr
        value = (2 * cov + 0.03**2) / (vx + vr + 0.03**2)
        if scale == 4:
            value = value * (2 * mx * mr + 0.01**2) / (mx * mx + mr * mr + 0.01**2)
        result *= max(value.mean(), 0) ** weight
    return result


def png(test, reference):
    x, r = [numpy.asarray(imageio.imread(name))[..., :3].astype(numpy.float64) / 255 for name in (test, reference)]
    ssim = structural_similarity(
        r, x, data_range=1, channel_axis=2, gaussian_weights=True, sigma=1.5, use_sample_covariance=False
    )
    return {
        "psnr": peak_signal_noise_ratio(r, x, data_range=1),
        "ssim": ssim,
        "ms_ssim": numpy.mean([ms_ssim_of_channel(x[..., c], r[..., c]) for c in range(3)]),
    }


def exr(name):
    source = OpenImageIO.ImageInput.open(name)
    spec = source.spec()
    names = list(spec.channelnames)
    formats = spec.channelformats or [spec.format] * len(names)
    values = numpy.asarray(source.read_image(OpenImageIO.FLOAT)).reshape(spec.height, spec.width, len(names))
    raw = {n: str(f) for n, f in zip(names, formats)}
    # OpenImageIO scales integers that are read as float to [0,1].
    scale = {n: 2.0**32 - 1 if raw[n].startswith("uint") else 1.0 for n in names}
    sums = {n: float(values[..., c].astype(numpy.float64).sum() * scale[n]) for c, n in enumerate(names)}
    return {
        "size": [spec.width, spec.height],
        "compression": spec.get_string_attribute("compression"),
        "formats": raw,
        "sums": sums,
        "run": spec.get_string_attribute("run"),
        "worldtocamera": [float(v) for v in spec.getattribute("worldtocamera") or []],
    }


if __name__ == "__main__":
    print(json.dumps({"png": png, "exr": exr}[sys.argv[1]](*sys.argv[2:])))
