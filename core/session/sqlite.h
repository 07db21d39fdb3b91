// The little of SQLite that the index needs, with failures as an exception that ends in swing_index.cpp.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace posecoach::sqlite {

struct Failure : std::runtime_error {
  Failure(int error_code, const char* message) : std::runtime_error(message), code(error_code) {}
  int code;
};

class Connection;

class Statement {
 public:
  Statement(const Connection& connection, std::string_view sql);

  // Parameters count from 1.
  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, std::int64_t number);
  Statement& bind(int parameter, double number);
  Statement& bind_nothing(int parameter);
  // Whether there is a row. After the last one the statement may be bound and run again.
  bool step();
  void run();

  std::string text(int column) const;
  std::int64_t number(int column) const { return sqlite3_column_int64(statement_.get(), column); }

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  void check(int code) const;

  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

class Connection {
 public:
  // ":memory:" is a database of this connection's own.
  explicit Connection(const std::filesystem::path& file);

  void run(const char* sql) const;
  sqlite3* get() const { return database_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  };
  std::unique_ptr<sqlite3, Close> database_;
};

// Rolled back unless committed.
class Transaction {
 public:
  Transaction(const Connection& connection, const char* begin) : connection_(connection) {
    connection.run(begin);
  }
  ~Transaction() {
    if (!is_done_) sqlite3_exec(connection_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit() {
    connection_.run("COMMIT");
    is_done_ = true;
  }

 private:
  const Connection& connection_;
  bool is_done_ = false;
};

}  // namespace posecoach::sqlite
