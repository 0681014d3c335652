"""The figures of a run, of its stations, joints, paths, devices and tasks, and the verdict."""
