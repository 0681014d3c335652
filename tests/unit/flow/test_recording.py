import numpy as np

from ropsim.flow import Channel, Recording


def test_a_recording_becomes_a_table_with_one_column_per_joint() -> None:
    time = np.array([0.0, 0.004])
    channels = {
        "q": Channel(np.array([[1.0, 2.0], [3.0, 4.0]]), "rad", ("1", "2")),
        "line": Channel(np.array([0.0, 7.0]), ""),
    }
    table = Recording(time, channels, (), (), 0.004).to_pandas()
    assert list(table.columns) == ["q[1]", "q[2]", "line"]
    assert table.index.name == "time"
    assert table["q[2]"].tolist() == [2.0, 4.0]
    assert table.index.tolist() == [0.0, 0.004]
