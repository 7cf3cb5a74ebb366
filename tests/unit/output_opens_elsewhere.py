"""Opens an output folder with h5py and follows every reference of particles.xdmf into results.h5.

usage: output_opens_elsewhere.py FOLDER      exit status 77: h5py is not installed
"""
import pathlib
import sys
import xml.etree.ElementTree as xml

try:
    import h5py
    import numpy as np
except ImportError as missing:
    print(missing)
    sys.exit(77)

folder = pathlib.Path(sys.argv[1])
with h5py.File(folder / "results.h5", "r") as file:
    assert file.attrs["format"] == "stresslet results"
    # The numbers of output_samples.hpp.
    strain = np.arange(6) / 3
    assert np.array_equal(file["series/strain"][:], strain)
    assert np.array_equal(file["series/relative_viscosity"][:], 1 + strain * strain)
    assert file["series/time"].attrs["unit"] == "1/shear rate"
    assert file["input/resolved"].asstr()[()] == "a = 1"
    assert file["provenance"].attrs["command_line"] == "run"
    assert sorted(file["snapshots"]) == ["000000", "000001", "000002"]
    for k, snapshot in enumerate(file["snapshots"].values()):
        x = 100 * k + 10 * np.arange(7)[:, None] + np.arange(3)
        assert np.array_equal(snapshot["position"][:], x / 3)
        assert np.array_equal(snapshot["velocity"][:], -x / 7)
        assert list(snapshot.attrs["box_length"]) == [3, 4, 5]
        assert snapshot["position"].fletcher32

    grids = xml.parse(folder / "particles.xdmf").getroot().findall("Domain/Grid/Grid")
    assert [float(grid.find("Time").get("Value")) for grid in grids] == [k / 7 for k in range(3)]
    for grid in grids:
        references = list(grid.iter("DataItem"))
        assert len(references) == 7
        for item in references:
            name, path = item.text.split(":")
            assert name == "results.h5"
            assert list(file[path].shape) == [int(n) for n in item.get("Dimensions").split()]
            kind = {"Float": "f", "Int": "i"}[item.get("NumberType")] + item.get("Precision")
            assert file[path].dtype == np.dtype(kind), (path, file[path].dtype)
