// A chart and its progress on the wire. Thread safety: functions without state.
#pragma once

#include <string>
#include <variant>

#include "gonio/chart/table.h"
#include "gonio/v1/chart.pb.h"
#include "wire/mapping/mapping.h"

namespace gonio::wire {

template <>
struct Mapping<chart::Progress> {
  using Own = chart::Progress;
  using Message = v1::ChartProgress;
  static constexpr auto kFields = fields<Own>(field(&Own::stage, Message::kStageFieldNumber),
                                              field(&Own::done, Message::kDoneFieldNumber));
};

template <>
struct Mapping<chart::Machine> {
  using Own = chart::Machine;
  using Message = v1::ChartMachine;
  static constexpr auto kFields =
      fields<Own>(field(&Own::processor, Message::kProcessorFieldNumber),
                  field(&Own::cores, Message::kCoresFieldNumber),
                  field(&Own::instruction_sets, Message::kInstructionSetsFieldNumber),
                  field(&Own::gonio, Message::kGonioFieldNumber),
                  field(&Own::compiler, Message::kCompilerFieldNumber),
                  field(&Own::system, Message::kSystemFieldNumber));
};

template <>
struct Mapping<chart::Column> {
  using Own = chart::Column;
  using Message = v1::ChartColumn;
  static constexpr auto kFields = fields<Own>(field(&Own::name, Message::kNameFieldNumber),
                                              field(&Own::unit, Message::kUnitFieldNumber),
                                              field(&Own::meaning, Message::kMeaningFieldNumber));
};

// A cell is a word or a number.
template <>
struct Mapping<chart::Row> {
  using Message = v1::ChartRow;
  static void write(const chart::Row& from, Message& to) {
    for (const chart::Cell& cell : from) {
      if (const auto* word = std::get_if<std::string>(&cell)) {
        to.add_cells()->set_word(*word);
      } else {
        to.add_cells()->set_number(std::get<double>(cell));
      }
    }
  }
  static Result<chart::Row> read(const Message& from) {
    chart::Row to;
    for (const v1::ChartCell& cell : from.cells()) {
      if (cell.value_case() == v1::ChartCell::kWord) {
        to.emplace_back(cell.word());
      } else {
        to.emplace_back(cell.number());
      }
    }
    return to;
  }
};

template <>
struct Mapping<chart::Table> {
  using Own = chart::Table;
  using Message = v1::ChartTable;
  static constexpr auto kFields = fields<Own>(field(&Own::name, Message::kNameFieldNumber),
                                              field(&Own::title, Message::kTitleFieldNumber),
                                              field(&Own::columns, Message::kColumnsFieldNumber),
                                              field(&Own::rows, Message::kRowsFieldNumber));
};

template <>
struct Mapping<chart::Chart> {
  using Own = chart::Chart;
  using Message = v1::ChartResult;
  static constexpr auto kFields = fields<Own>(field(&Own::machine, Message::kMachineFieldNumber),
                                              field(&Own::tables, Message::kTablesFieldNumber));
};

}  // namespace gonio::wire
