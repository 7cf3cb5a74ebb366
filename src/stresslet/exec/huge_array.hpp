#pragma once
/// Large zero-initialised arrays on huge pages where the system gives them. Pages are mapped on first touch, so that
/// the thread that first writes a part decides where it lies.
#include <cstddef>

namespace stresslet {

/// A block of memory, zero everywhere. Throws std::bad_alloc where the system refuses.
class HugeMemory {
 public:
  HugeMemory() = default;
  explicit HugeMemory(std::size_t bytes);
  HugeMemory(HugeMemory&& other) noexcept;
  HugeMemory& operator=(HugeMemory&& other) noexcept;
  ~HugeMemory();

  void* data() const { return data_; }
  std::size_t bytes() const { return bytes_; }

 private:
  void* data_ = nullptr;
  std::size_t bytes_ = 0;
};

template <class T>
class HugeArray {
 public:
  HugeArray() = default;
  explicit HugeArray(std::size_t size) : memory_(size * sizeof(T)), size_(size) {}
  T* data() const { return static_cast<T*>(memory_.data()); }
  std::size_t size() const { return size_; }

 private:
  HugeMemory memory_;
  std::size_t size_ = 0;
};

/// Makes room for `size` values and some more; what was there is lost where there was no room.
template <class T>
void make_room(HugeArray<T>& array, std::size_t size) {
  if (array.size() < size) array = HugeArray<T>(size + size / 4);
}

/// Memory of this machine in bytes, 0 where it cannot be told.
std::size_t physical_memory();

}  // namespace stresslet
