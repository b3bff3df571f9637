//! The tags that are read (TIFF 6.0; OGC 19-008r4, annex B; GDAL's and Esri's own), with the names
//! by which they are refused.

/// A tag of a directory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tag {
    pub(super) number: u16,
    pub(super) name: &'static str,
}

/// Constants of tags.
macro_rules! tags {
    ($($constant:ident = $number:literal $name:literal;)*) => {
        $(pub(super) const $constant: Tag = Tag { number: $number, name: $name };)*
    };
}

tags! {
    NEW_SUBFILE_TYPE = 254 "NewSubfileType";
    IMAGE_WIDTH = 256 "ImageWidth";
    IMAGE_LENGTH = 257 "ImageLength";
    BITS_PER_SAMPLE = 258 "BitsPerSample";
    COMPRESSION = 259 "Compression";
    PHOTOMETRIC = 262 "PhotometricInterpretation";
    FILL_ORDER = 266 "FillOrder";
    STRIP_OFFSETS = 273 "StripOffsets";
    SAMPLES_PER_PIXEL = 277 "SamplesPerPixel";
    ROWS_PER_STRIP = 278 "RowsPerStrip";
    STRIP_BYTE_COUNTS = 279 "StripByteCounts";
    PLANAR_CONFIGURATION = 284 "PlanarConfiguration";
    PREDICTOR = 317 "Predictor";
    TILE_WIDTH = 322 "TileWidth";
    TILE_LENGTH = 323 "TileLength";
    TILE_OFFSETS = 324 "TileOffsets";
    TILE_BYTE_COUNTS = 325 "TileByteCounts";
    EXTRA_SAMPLES = 338 "ExtraSamples";
    SAMPLE_FORMAT = 339 "SampleFormat";
    MODEL_PIXEL_SCALE = 33_550 "ModelPixelScale";
    MODEL_TIEPOINT = 33_922 "ModelTiepoint";
    MODEL_TRANSFORMATION = 34_264 "ModelTransformation";
    GEO_KEY_DIRECTORY = 34_735 "GeoKeyDirectory";
    GEO_DOUBLE_PARAMS = 34_736 "GeoDoubleParams";
    GEO_ASCII_PARAMS = 34_737 "GeoAsciiParams";
    GDAL_METADATA = 42_112 "GDAL_METADATA";
    GDAL_NODATA = 42_113 "GDAL_NODATA";
    LERC_PARAMETERS = 50_674 "LercParameters";
}
