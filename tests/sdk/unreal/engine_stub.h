// SPDX-License-Identifier: MIT
// The part of Unreal's API that the plugin uses, so that it compiles and runs without the engine.
// The names are those of the engine.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

using uint8 = std::uint8_t;
using uint16 = std::uint16_t;
using int32 = std::int32_t;
using int64 = std::int64_t;
using TCHAR = char16_t;
#define TEXT(x) u##x

// Markers for Unreal's header tool.
#define UCLASS(...)
#define USTRUCT(...)
#define UENUM(...)
#define UPROPERTY(...)
#define UFUNCTION(...)
#define GENERATED_BODY()
#define HEDGEHOGHAPTICS_API
#define IMPLEMENT_MODULE(Class, Name) \
  Class Module##Name() { return {}; }
struct FDefaultModuleImpl {};

std::string stub_utf8(const TCHAR* text);
std::u16string stub_utf16(const char* text);
#define TCHAR_TO_UTF8(text) stub_utf8(text).c_str()
#define UTF8_TO_TCHAR(text) stub_utf16(text).c_str()

class FString {
 public:
  FString() = default;
  FString(const TCHAR* text) : text_(text) {}
  const TCHAR* operator*() const { return text_.c_str(); }
  bool IsEmpty() const { return text_.empty(); }

 private:
  std::u16string text_;
};

struct FVector {
  FVector(double x, double y, double z) : X(x), Y(y), Z(z) {}
  FVector operator-() const { return {-X, -Y, -Z}; }
  static const FVector ZeroVector;
  double X, Y, Z;
};
inline const FVector FVector::ZeroVector{0, 0, 0};

struct FQuat {
  FQuat(double x, double y, double z, double w) : X(x), Y(y), Z(z), W(w) {}
  static const FQuat Identity;
  double X, Y, Z, W;
};
inline const FQuat FQuat::Identity{0, 0, 0, 1};

template <class T>
class TArray {
 public:
  void Add(const T& item) { items_.push_back(item); }
  int32 Num() const { return static_cast<int32>(items_.size()); }
  const T& operator[](int32 index) const { return items_[static_cast<std::size_t>(index)]; }

 private:
  std::vector<T> items_;
};

// The log.
#define DEFINE_LOG_CATEGORY_STATIC(Name, Default, Max) static const char* const Name = #Name
#define UE_LOG(Category, Verbosity, Format, ...) stub_log(Category, Format, __VA_ARGS__)
void stub_log(const char* category, const TCHAR* format, const TCHAR* a, const TCHAR* b = nullptr);

struct FPlatformTime {
  static double Seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
  }
};

// Delegates; the engine binds only UFUNCTIONs, `bound` any function.
#define DECLARE_DYNAMIC_DELEGATE_OneParam(Name, Type, Param) \
  struct Name {                                              \
    void ExecuteIfBound(Type value) const {                  \
      if (bound) bound(value);                               \
    }                                                        \
    std::function<void(Type)> bound{};                       \
  }
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(Name, Type, Param) \
  struct Name {                                                        \
    void Broadcast(Type value) const {                                 \
      for (const auto& one : bound) one(value);                        \
    }                                                                  \
    std::vector<std::function<void(Type)>> bound{};                    \
  }
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE(Name) \
  struct Name {                                  \
    void Broadcast() const {                     \
      for (const auto& one : bound) one();       \
    }                                            \
    std::vector<std::function<void()>> bound{};  \
  }

struct FSubsystemCollectionBase {};
class UGameInstanceSubsystem {
 public:
  using Super = UGameInstanceSubsystem;
  virtual ~UGameInstanceSubsystem() = default;
  virtual void Initialize(FSubsystemCollectionBase&) {}
  virtual void Deinitialize() {}
};

struct TStatId {};
#define RETURN_QUICK_DECLARE_CYCLE_STAT(Name, Group) return TStatId()
class FTickableGameObject {
 public:
  virtual ~FTickableGameObject() = default;
  virtual void Tick(float) = 0;
  virtual bool IsTickable() const { return true; }
  virtual bool IsTickableWhenPaused() const { return false; }
  virtual TStatId GetStatId() const = 0;
};
