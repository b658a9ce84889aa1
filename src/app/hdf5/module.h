#pragma once

/* What the program and its module flatray_hdf5.so say to each other: plain structs. */

#define FLATRAY_HDF5_ABI 1
#define FLATRAY_HDF5_ENTRY "flatray_hdf5_module"

enum FlatrayHdf5Kind { FLATRAY_HDF5_WHOLE, FLATRAY_HDF5_REAL, FLATRAY_HDF5_TEXT };

struct FlatrayHdf5Column {
  const char* name;
  FlatrayHdf5Kind kind;
  unsigned bytes; /* 8, or what a text is filled up to with zeros */
};

/* Numbers, little end first, row by row: of so many columns, or, of none, whole ones. */
struct FlatrayHdf5Array {
  const char *name, *caption;
  const FlatrayHdf5Column* columns;
  unsigned column_count;
  const unsigned long long* shape;
  unsigned dimensions; /* 1 or 2 */
  const void* numbers;
};

struct FlatrayHdf5Attribute {
  const char *name, *text;
};

struct FlatrayHdf5Module {
  int abi;
  const char* version;
  /* Gives the bytes of a file to `take`; false where the library fails. */
  bool (*write)(const FlatrayHdf5Array* arrays, unsigned array_count,
                const FlatrayHdf5Attribute* attributes, unsigned attribute_count,
                void (*take)(void* to, const char* bytes, unsigned long long count), void* to);
};
