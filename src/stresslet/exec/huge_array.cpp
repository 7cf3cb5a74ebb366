#include "stresslet/exec/huge_array.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <new>
#include <utility>

namespace stresslet {

namespace {
constexpr std::size_t huge_page = std::size_t(2) << 20;
}

HugeMemory::HugeMemory(std::size_t bytes) : bytes_((bytes + huge_page - 1) / huge_page * huge_page) {
  if (bytes == 0) return;
  // One page more than needed, so that the start can be moved to a huge-page boundary; the rest is given back.
  void* mapped = mmap(nullptr, bytes_ + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  char* const start = static_cast<char*>(mapped);
  const std::size_t lead = (huge_page - std::size_t(start) % huge_page) % huge_page;
  if (lead) munmap(start, lead);
  if (lead < huge_page) munmap(start + lead + bytes_, huge_page - lead);
  data_ = start + lead;
  madvise(data_, bytes_, MADV_HUGEPAGE);
}

HugeMemory::HugeMemory(HugeMemory&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}

HugeMemory& HugeMemory::operator=(HugeMemory&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

HugeMemory::~HugeMemory() {
  if (data_) munmap(data_, bytes_);
}

std::size_t physical_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  return pages > 0 && size > 0 ? std::size_t(pages) * std::size_t(size) : 0;
}

}  // namespace stresslet
