#include "app/hdf5/module.h"

#include <hdf5.h>

#include <cstring>
#include <vector>

namespace {

// Something of the library, closed where it goes out of scope.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

// A plist of a class, without the times of objects: the same numbers are the same bytes.
Handle creation_of(hid_t kind) {
  const hid_t list = H5Pcreate(kind);
  H5Pset_obj_track_times(list, false);
  return {list, &H5Pclose};
}

bool write_text(hid_t object, const char* name, const char* text) {
  const Handle type(H5Tcopy(H5T_C_S1), &H5Tclose), space(H5Screate(H5S_SCALAR), &H5Sclose);
  H5Tset_size(type, std::strlen(text) + 1);
  H5Tset_cset(type, H5T_CSET_UTF8);
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
                         &H5Aclose);
  return attribute >= 0 && H5Awrite(attribute, type, text) >= 0;
}

hid_t type_of(const FlatrayHdf5Array& array) {
  if (array.column_count == 0) return H5Tcopy(H5T_STD_U64LE);
  std::size_t size = 0, at = 0;
  for (unsigned i = 0; i < array.column_count; ++i) size += array.columns[i].bytes;
  const hid_t row = H5Tcreate(H5T_COMPOUND, size);
  for (unsigned i = 0; i < array.column_count; ++i) {
    const FlatrayHdf5Column& one = array.columns[i];
    const Handle type(H5Tcopy(one.kind == FLATRAY_HDF5_TEXT   ? H5T_C_S1
                              : one.kind == FLATRAY_HDF5_REAL ? H5T_IEEE_F64LE
                                                              : H5T_STD_U64LE),
                      &H5Tclose);
    if (one.kind == FLATRAY_HDF5_TEXT) {
      H5Tset_size(type, one.bytes);
      H5Tset_strpad(type, H5T_STR_NULLPAD);
      H5Tset_cset(type, H5T_CSET_UTF8);
    }
    H5Tinsert(row, one.name, at, type);
    at += one.bytes;
  }
  return row;
}

bool write_array(hid_t file, const FlatrayHdf5Array& array) {
  const std::vector<hsize_t> shape(array.shape, array.shape + array.dimensions);
  const Handle type(type_of(array), &H5Tclose),
      space(H5Screate_simple(static_cast<int>(array.dimensions), shape.data(), nullptr), &H5Sclose),
      creation = creation_of(H5P_DATASET_CREATE),
      data(H5Dcreate2(file, array.name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
           &H5Dclose);
  return data >= 0 && H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.numbers) >= 0 &&
         write_text(data, "caption", array.caption);
}

// In memory: the program writes files itself.
bool write(const FlatrayHdf5Array* arrays, unsigned array_count,
           const FlatrayHdf5Attribute* attributes, unsigned attribute_count,
           void (*take)(void*, const char*, unsigned long long), void* to) {
  constexpr std::size_t kStep = std::size_t{1} << 20;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Handle creation = creation_of(H5P_FILE_CREATE),
               access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
  H5Pset_fapl_core(access, kStep, false);
  const Handle file(H5Fcreate("flatray.h5", H5F_ACC_TRUNC, creation, access), &H5Fclose);
  bool written = file >= 0;
  for (unsigned i = 0; i < attribute_count && written; ++i)
    written = write_text(file, attributes[i].name, attributes[i].text);
  for (unsigned i = 0; i < array_count && written; ++i) written = write_array(file, arrays[i]);
  if (!written || H5Fflush(file, H5F_SCOPE_GLOBAL) < 0) return false;
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size <= 0) return false;
  std::vector<char> image(static_cast<std::size_t>(size));
  if (H5Fget_file_image(file, image.data(), image.size()) != size) return false;
  take(to, image.data(), image.size());
  return true;
}

constexpr FlatrayHdf5Module kModule = {FLATRAY_HDF5_ABI, H5_VERS_INFO, &write};

}  // namespace

extern "C" __attribute__((visibility("default"))) const FlatrayHdf5Module* flatray_hdf5_module() {
  return &kModule;
}
