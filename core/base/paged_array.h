#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace kerf {

// A sparse array: an item that was never written reads as T(), and only pages that were written take memory.
// Growing moves no item.
template <typename T>
class PagedArray {
 public:
  static constexpr uint32_t kPage = 1024;  // items a page

  PagedArray() = default;
  PagedArray(PagedArray&&) noexcept = default;
  PagedArray& operator=(PagedArray&&) noexcept = default;
  PagedArray(const PagedArray& other) : pages_(other.pages_.size()) {
    for (size_t i = 0; i < pages_.size(); ++i) {
      if (other.pages_[i]) pages_[i] = std::make_unique<Page>(*other.pages_[i]);
    }
  }
  PagedArray& operator=(const PagedArray& other) { return *this = PagedArray(other); }

  T get(uint32_t i) const {
    const Page* page = page_of(i);
    return page ? (*page)[i % kPage] : T();
  }
  // The item, for writing; allocates its page.
  T& at(uint32_t i) {
    const size_t page = i / kPage;
    if (page >= pages_.size()) pages_.resize(page + 1);
    if (!pages_[page]) pages_[page] = std::make_unique<Page>();
    return (*pages_[page])[i % kPage];
  }

  void prefetch(uint32_t i) const {
    if (const Page* page = page_of(i)) __builtin_prefetch(&(*page)[i % kPage]);
  }

  // An upper bound of the indices written so far, exclusive.
  uint32_t end() const { return static_cast<uint32_t>(pages_.size()) * kPage; }
  // The items of the page with item i, the one with index i - i % kPage first; null if none of them was
  // written.
  const T* page(uint32_t i) const {
    const Page* page = page_of(i);
    return page ? page->data() : nullptr;
  }

  void clear() { pages_.clear(); }
  // Memory allocated, in bytes.
  size_t bytes() const {
    size_t bytes = pages_.capacity() * sizeof(pages_[0]);
    for (const auto& page : pages_) bytes += page ? sizeof(Page) : 0;
    return bytes;
  }

 private:
  using Page = std::array<T, kPage>;
  const Page* page_of(uint32_t i) const {
    return i / kPage < pages_.size() ? pages_[i / kPage].get() : nullptr;
  }

  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace kerf
