// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/lms3dVRMLEvaluator.h"

#include "Grammar/lms3dVRMLContext.h"
#include "Grammar/lms3dVRMLNodeTypes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
std::int32_t ToInteger(double x)
{
  const bool isInteger =
    std::abs(x) <= std::numeric_limits<std::int32_t>::max() && x == std::floor(x);
  return isInteger ? static_cast<std::int32_t>(x) : std::numeric_limits<std::int32_t>::min();
}

// Shares the list of the document, which outlives all users of the pointer.
template <typename List>
std::shared_ptr<const List> Borrow(const List& list)
{
  return { std::shared_ptr<const List>(), &list };
}

// Converts a list once for all nodes that share it. Returns an empty list if the limit of memory is
// exceeded.
template <typename From, typename To, typename Function, typename Count>
std::shared_ptr<const To> ConvertOnce(const From& list, std::shared_ptr<const To>& known,
  const Function& convert, const Count& countMemory)
{
  if (!known && !countMemory(list.size() * sizeof(typename To::value_type)))
  {
    return std::make_shared<To>();
  }
  if (!known)
  {
    auto converted = std::make_shared<To>(list.size());
    std::transform(list.begin(), list.end(), converted->begin(), convert);
    known = std::move(converted);
  }
  return known;
}

bool IsEmptyList(const lms3dVRMLValue& value)
{
  const auto* nodes = std::get_if<lms3dVRMLNodes>(&value);
  return nodes && nodes->empty();
}
} // namespace

void lms3dVRMLEvaluator::RejectKind(const lms3dVRMLNodeInContext& node, std::string_view name,
  const FoundValue& found, const char* kind)
{
  if (!IsEmptyList(*found.Value))
  {
    this->Reject(name, found.Document->FileName, found.Line,
      std::string(name) + " of " + std::string(node.Node->TypeName) + " should be " + kind +
        "; the default is used");
  }
}

void lms3dVRMLEvaluator::Reject(
  std::string_view name, const std::string& file, std::size_t line, const std::string& text)
{
  if (lms3dIsVRMLColorField(name))
  {
    this->Context.Messages.AddWarning(file, line, text);
  }
  else
  {
    this->Context.Messages.AddError(file, line, text);
  }
}

void lms3dVRMLEvaluator::CopyNumbers(
  const lms3dVRMLNodeInContext& node, std::string_view name, double* numbers, std::size_t count)
{
  const FoundValue found = this->Find(node, name);
  if (!found.Value)
  {
    return;
  }
  const auto* integers = std::get_if<lms3dVRMLIntegers>(found.Value);
  const auto* reals = std::get_if<lms3dVRMLReals>(found.Value);
  const std::size_t given = integers ? integers->size() : reals ? reals->size() : 0;
  if (given < count)
  {
    this->RejectKind(
      node, name, found, count == 1 ? "a number" : (std::to_string(count) + " numbers").c_str());
    return;
  }
  if (given > count)
  {
    this->Context.Messages.AddWarning(found.Document->FileName, found.Line,
      std::string(name) + " of " + std::string(node.Node->TypeName) + " has too many numbers");
  }
  if (integers)
  {
    std::copy_n(integers->begin(), count, numbers);
  }
  else
  {
    std::copy_n(reals->begin(), count, numbers);
  }
}

double lms3dVRMLEvaluator::GetNumber(
  const lms3dVRMLNodeInContext& node, std::string_view name, double fallback)
{
  return this->GetVector<1>(node, name, { fallback })[0];
}

bool lms3dVRMLEvaluator::GetBool(
  const lms3dVRMLNodeInContext& node, std::string_view name, bool fallback)
{
  const FoundValue found = this->Find(node, name);
  const bool* isTrue = found.Value ? std::get_if<bool>(found.Value) : nullptr;
  if (found.Value && !isTrue)
  {
    this->RejectKind(node, name, found, "TRUE or FALSE");
  }
  return isTrue ? *isTrue : fallback;
}

std::shared_ptr<const lms3dVRMLReals> lms3dVRMLEvaluator::GetReals(
  const lms3dVRMLNodeInContext& node, std::string_view name, std::size_t tuple,
  const lms3dVRMLReals& fallback)
{
  const FoundValue found = this->Find(node, name);
  if (!found.Value)
  {
    return std::make_shared<lms3dVRMLReals>(fallback);
  }
  std::shared_ptr<const lms3dVRMLReals> list;
  if (const auto* reals = std::get_if<lms3dVRMLReals>(found.Value))
  {
    list = Borrow(*reals);
  }
  else if (const auto* integers = std::get_if<lms3dVRMLIntegers>(found.Value))
  {
    list = ConvertOnce(
      *integers, this->AsReals[found.Value], [](std::int32_t x) { return x; },
      [this, &node](std::size_t bytes) { return this->CountMemory(node, bytes); });
  }
  else
  {
    this->RejectKind(node, name, found, "numbers");
    return std::make_shared<lms3dVRMLReals>();
  }
  if (list->size() % tuple != 0)
  {
    this->Context.Messages.AddWarning(found.Document->FileName, found.Line,
      std::string(name) + " of " + std::string(node.Node->TypeName) + " has " +
        std::to_string(list->size()) + " numbers, not a multiple of " + std::to_string(tuple) +
        "; the last ones are skipped");
  }
  return list;
}

std::shared_ptr<const lms3dVRMLIntegers> lms3dVRMLEvaluator::GetIntegers(
  const lms3dVRMLNodeInContext& node, std::string_view name)
{
  const FoundValue found = this->Find(node, name);
  const lms3dVRMLValue* value = found.Value;
  if (const auto* integers = value ? std::get_if<lms3dVRMLIntegers>(value) : nullptr)
  {
    return Borrow(*integers);
  }
  if (const auto* reals = value ? std::get_if<lms3dVRMLReals>(value) : nullptr)
  {
    return ConvertOnce(*reals, this->AsIntegers[value], ToInteger,
      [this, &node](std::size_t bytes) { return this->CountMemory(node, bytes); });
  }
  if (value)
  {
    this->RejectKind(node, name, found, "integers");
  }
  return std::make_shared<lms3dVRMLIntegers>();
}

lms3dVRMLEvaluator::Urls lms3dVRMLEvaluator::GetUrls(const lms3dVRMLNodeInContext& node)
{
  const FoundValue found = this->Find(node, "url");
  const auto* strings = found.Value ? std::get_if<lms3dVRMLStrings>(found.Value) : nullptr;
  if (found.Value && !strings)
  {
    this->RejectKind(node, "url", found, "strings");
  }
  return { strings ? *strings : lms3dVRMLStrings(), found.Document };
}
