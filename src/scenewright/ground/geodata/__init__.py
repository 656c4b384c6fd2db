"""Maps in the files of GIS programs and of OpenStreetMap, read by GDAL, as features of GeoJSON."""
