/**
 * A converter's journal: each input of its core is written to a file before it takes effect, so that another process
 * can continue where this one ended.
 *
 * <pre>
 *            Input                         bytes                        file
 *  driver ─────────▶ Recorder ─ Encoder ─────────▶ Segment (mapped) ─────────▶ DIR/0000000007.journal
 *                       │                             ▲
 *                       ▼                             │ force, every 100 ms
 *                     core                          Forcer
 *
 *  DIR ─▶ Directory ─▶ SegmentReader ─ Decoder ─▶ Replay ─▶ a core of its own ─▶ Snapshot
 * </pre>
 *
 * <p>A segment is a preamble, then records: its {@link org.evoloop.journal.Head}, the core's snapshot as text, then
 * inputs. {@link org.evoloop.journal.Frame} describes the layout of a record, and docs/journal.md the guarantees.
 *
 * <p>This package may use {@code org.evoloop.converter}, {@code core}, {@code evolution}, {@code statemachine}, {@code
 * time} and {@code check.temporal}.
 */
@NullMarked
package org.evoloop.journal;

import org.jspecify.annotations.NullMarked;
