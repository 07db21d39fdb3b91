#include "core/session/swing_index.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cmath>
#include <map>
#include <optional>
#include <variant>

#include "core/base/assert.h"
#include "core/base/log.h"
#include "core/session/file_name.h"
#include "core/session/sqlite.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr std::int64_t kVersion = 1;
// "PCsw": whose file this is.
constexpr std::int64_t kApplication = 0x50437377;

constexpr const char* kMakeTables =
    "CREATE TABLE swings (shelf INTEGER NOT NULL, id TEXT NOT NULL, stamp TEXT NOT NULL, text TEXT NOT NULL,"
    " unreadable TEXT NOT NULL, recorded INTEGER NOT NULL, day TEXT NOT NULL, person TEXT NOT NULL,"
    " coach TEXT NOT NULL, star INTEGER NOT NULL, score INTEGER, words TEXT NOT NULL, proof INTEGER NOT NULL,"
    " PRIMARY KEY (shelf, id)) WITHOUT ROWID;"
    "CREATE INDEX by_date ON swings (shelf, recorded);";

// FNV-1a over what a row says: a row that was damaged on the disk is found when the index is opened.
class Proof {
 public:
  void add(std::string_view text) {
    for (const char c : text) mix(static_cast<unsigned char>(c));
    mix(0);
  }
  void add(std::int64_t number) { add(std::to_string(number)); }
  std::int64_t value() const { return static_cast<std::int64_t>(hash_); }

 private:
  void mix(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3U; }
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

struct Row {
  FoundSwing found;
  std::string text, unreadable, day, person, coach, words;
  std::int64_t recorded = 0, star = 0;
  std::string score;  // as SQLite prints it; empty: none

  std::int64_t proof() const {
    Proof proof;
    proof.add(static_cast<std::int64_t>(found.shelf));
    for (const std::string* part :
         {&found.id, &found.stamp, &text, &unreadable, &day, &person, &coach, &words})
      proof.add(*part);
    proof.add(recorded);
    proof.add(star);
    proof.add(score);
    return proof.value();
  }
};

Row row_of(const FoundSwing& found, const IndexedSwing& swing) {
  Row row;
  row.found = found;
  row.text = swing.text;
  row.unreadable = swing.unreadable;
  if (!swing.unreadable.empty()) return row;
  const Result<Swing> read = swing_from_json(fs::path(found.id), swing.text);
  if (!read) {
    row.unreadable = read.error().message;
    return row;
  }
  const SwingFacts& facts = read->facts;
  row.recorded = facts.recorded_at.utc.time_since_epoch().count();
  row.day = day_of(facts.recorded_at);
  row.person = folded(facts.person);
  row.coach = facts.coach;
  row.star = facts.star ? 1 : 0;
  // Hundredths of a percent: a whole number is proved and compared without doubt.
  if (facts.score_percent) row.score = std::to_string(std::llround(*facts.score_percent * 100));
  for (const std::string& part : {facts.notes, facts.person, facts.coach, facts.view, facts.stroke,
                                  facts.advice, facts.source, row.day})
    row.words += folded(part) + "\n";
  return row;
}

// Held while the index is opened and made, so that two programs do not make it at once.
class OpeningLock {
 public:
  explicit OpeningLock(const fs::path& file)
      : descriptor_(::open((file.string() + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
  }
  ~OpeningLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpeningLock(const OpeningLock&) = delete;
  OpeningLock& operator=(const OpeningLock&) = delete;

 private:
  int descriptor_;
};

using Value = std::variant<std::string, std::int64_t>;

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (const char c : folded(text) + " ") {
    const bool is_gap = c == ' ' || c == '\t' || c == '\n';
    if (!is_gap && (words.empty() || words.back().ends_with(' '))) words.emplace_back();
    if (!is_gap) words.back() += c;
    if (is_gap && !words.empty() && !words.back().ends_with(' ')) words.back() += ' ';
  }
  for (std::string& word : words)
    if (word.ends_with(' ')) word.pop_back();
  return words;
}

struct Question {
  std::string sql;
  std::vector<Value> values;

  void also(const std::string& condition, Value value) {
    sql += " AND " + condition;
    values.push_back(std::move(value));
  }
};

Question question_for(const SwingQuery& query) {
  Question question{"SELECT id, text FROM swings WHERE unreadable = ''", {}};
  question.also("shelf = ?", static_cast<std::int64_t>(query.shelf));
  for (const std::string& word : words_of(query.text)) question.also("instr(words, ?) > 0", word);
  if (!query.person.empty()) question.also("person = ?", folded(query.person));
  if (!query.coach.empty()) question.also("coach = ?", query.coach);
  if (!query.since.empty()) question.also("day >= ?", query.since);
  if (!query.until.empty()) question.also("day <= ?", query.until);
  if (query.star != StarFilter::Any)
    question.also("star = ?", std::int64_t{query.star == StarFilter::Starred ? 1 : 0});
  if (query.score_from) question.also("score >= ?", std::int64_t{std::llround(*query.score_from * 100)});
  if (query.score_to) question.also("score <= ?", std::int64_t{std::llround(*query.score_to * 100)});
  switch (query.order) {
    case SwingOrder::NewestFirst:
      question.sql += " ORDER BY recorded DESC, id DESC";
      break;
    case SwingOrder::OldestFirst:
      question.sql += " ORDER BY recorded, id";
      break;
    case SwingOrder::BestFirst:
      question.sql += " ORDER BY score IS NULL, score DESC, recorded DESC, id DESC";
      break;
    case SwingOrder::WorstFirst:
      question.sql += " ORDER BY score IS NULL, score, recorded DESC, id DESC";
      break;
  }
  if (query.limit > 0) {
    question.sql += " LIMIT ?";
    question.values.push_back(static_cast<std::int64_t>(query.limit));
  }
  return question;
}

bool is_search(const SwingQuery& query) {
  return !query.text.empty() || !query.person.empty() || !query.coach.empty() || !query.since.empty() ||
         !query.until.empty() || query.star != StarFilter::Any || query.score_from || query.score_to;
}

void remove_index(const fs::path& file) {
  std::error_code ignored;
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) fs::remove(file.string() + ending, ignored);
}

}  // namespace

class SwingIndex::Database {
 public:
  // Throws where the file is damaged or not ours.
  explicit Database(const fs::path& file) : connection_(file) {
    connection_.run("PRAGMA journal_mode = WAL");
    // What a power cut does to it is found by prove(), and costs nothing.
    connection_.run("PRAGMA synchronous = OFF");
    const std::int64_t version = pragma("PRAGMA user_version"), whose = pragma("PRAGMA application_id");
    if (version == 0 && whose == 0 && pragma("SELECT count(*) FROM sqlite_schema") == 0)
      make();
    else if (version != kVersion || whose != kApplication)
      throw sqlite::Failure(SQLITE_NOTADB, "it is of another version");
    else
      prove();
  }

  void update(const std::vector<FoundSwing>& found, const ReadSwing& read) {
    std::map<std::pair<Shelf, std::string>, std::string> known;
    sqlite::Statement stamps(connection_, "SELECT shelf, id, stamp FROM swings");
    while (stamps.step()) known[{static_cast<Shelf>(stamps.number(0)), stamps.text(1)}] = stamps.text(2);
    std::vector<Row> changed;
    for (const FoundSwing& swing : found) {
      const auto at = known.find({swing.shelf, swing.id});
      if (at == known.end() || at->second != swing.stamp) changed.push_back(row_of(swing, read(swing)));
      if (at != known.end()) known.erase(at);
    }
    if (changed.empty() && known.empty()) return;
    sqlite::Transaction transaction(connection_, "BEGIN IMMEDIATE");
    for (const auto& [key, stamp] : known) {
      sqlite::Statement(connection_, "DELETE FROM swings WHERE shelf = ? AND id = ?")
          .bind(1, static_cast<std::int64_t>(key.first))
          .bind(2, key.second)
          .run();
    }
    sqlite::Statement put(connection_, "INSERT OR REPLACE INTO swings VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?)");
    for (const Row& row : changed) store(put, row);
    transaction.commit();
  }

  std::vector<IndexedSwing> ask(const SwingQuery& query) const {
    std::vector<IndexedSwing> swings;
    const Question question = question_for(query);
    sqlite::Statement good(connection_, question.sql);
    for (std::size_t i = 0; i < question.values.size(); ++i)
      std::visit([&](const auto& value) { good.bind(static_cast<int>(i + 1), value); }, question.values[i]);
    while (good.step()) swings.push_back({query.shelf, good.text(0), good.text(1), {}});
    if (is_search(query)) return swings;
    sqlite::Statement bad(
        connection_, "SELECT id, unreadable FROM swings WHERE shelf = ? AND unreadable <> '' ORDER BY id");
    bad.bind(1, static_cast<std::int64_t>(query.shelf));
    while (bad.step()) swings.push_back({query.shelf, bad.text(0), {}, bad.text(1)});
    return swings;
  }

 private:
  std::int64_t pragma(const char* sql) const {
    sqlite::Statement statement(connection_, sql);
    return statement.step() ? statement.number(0) : 0;
  }

  void make() const {
    sqlite::Transaction transaction(connection_, "BEGIN IMMEDIATE");
    connection_.run(kMakeTables);
    connection_.run(("PRAGMA application_id = " + std::to_string(kApplication)).c_str());
    connection_.run(("PRAGMA user_version = " + std::to_string(kVersion)).c_str());
    transaction.commit();
  }

  // SQLite's own check finds damaged pages; damage within a text is ours to find.
  void prove() const {
    sqlite::Statement check(connection_, "PRAGMA quick_check(1)");
    if (!check.step() || check.text(0) != "ok")
      throw sqlite::Failure(SQLITE_CORRUPT, "its pages are damaged");
    check.run();
    sqlite::Statement rows(connection_,
                           "SELECT shelf, id, stamp, text, unreadable, recorded, day, person, coach, star,"
                           " score, words, proof FROM swings");
    while (rows.step()) {
      Row row;
      row.found = {static_cast<Shelf>(rows.number(0)), rows.text(1), rows.text(2)};
      row.text = rows.text(3);
      row.unreadable = rows.text(4);
      row.recorded = rows.number(5);
      row.day = rows.text(6);
      row.person = rows.text(7);
      row.coach = rows.text(8);
      row.star = rows.number(9);
      row.score = rows.text(10);
      row.words = rows.text(11);
      if (row.proof() != rows.number(12)) throw sqlite::Failure(SQLITE_CORRUPT, "an entry is damaged");
    }
  }

  static void store(sqlite::Statement& put, const Row& row) {
    put.bind(1, static_cast<std::int64_t>(row.found.shelf)).bind(2, row.found.id).bind(3, row.found.stamp);
    put.bind(4, row.text).bind(5, row.unreadable).bind(6, row.recorded).bind(7, row.day);
    put.bind(8, row.person).bind(9, row.coach).bind(10, row.star);
    if (row.score.empty())
      put.bind_nothing(11);
    else
      put.bind(11, std::int64_t{std::stoll(row.score)});
    put.bind(12, row.words).bind(13, row.proof()).run();
  }

  sqlite::Connection connection_;
};

SwingIndex::SwingIndex(fs::path file) : file_(std::move(file)) {}
SwingIndex::~SwingIndex() = default;

// As it is; else made again in its place; else in memory.
void SwingIndex::start_anew() {
  database_.reset();
  if (file_ != ":memory:") {
    const OpeningLock lock(file_);
    for (int attempt = 0; attempt < 2 && !database_; ++attempt) {
      try {
        database_ = std::make_unique<Database>(file_);
      } catch (const sqlite::Failure& failure) {
        const bool is_damaged = failure.code == SQLITE_CORRUPT || failure.code == SQLITE_NOTADB ||
                                failure.code == SQLITE_ERROR || failure.code == SQLITE_IOERR;
        if (!is_damaged || attempt > 0) break;
        log::info(file_.string() + " is made again: " + failure.what());
        remove_index(file_);
      }
    }
  }
  if (!database_) {
    file_ = ":memory:";
    database_ = std::make_unique<Database>(file_);
  }
}

std::vector<IndexedSwing> SwingIndex::list(const std::vector<FoundSwing>& found, const ReadSwing& read,
                                           const SwingQuery& query) {
  for (int attempt = 0;; ++attempt) {
    try {
      if (!database_) start_anew();
      database_->update(found, read);
      return database_->ask(query);
    } catch (const sqlite::Failure& failure) {
      log::info(file_.string() + ": " + failure.what());
      // A second failure in a row, of a full disk for one, is not waited for.
      if (attempt > 0) file_ = ":memory:";
      POSECOACH_ASSERT(attempt < 2);
      database_.reset();
    }
  }
}

}  // namespace posecoach
