"""Files of strangers: bounded folders, XML trees, values, meshes."""
