/**
 * The one encoding of events, steps, decisions, occurrences and snapshots: each is described once, by what writes it and what
 * reads it, as items. Items become lines of text, or bytes.
 *
 * <pre>
 *  what                        writes             reads              items: as text             as bytes
 *  event, decision, ...        ElementWriter      ElementReader
 *  a core's state              SnapshotWriter     SnapshotReader     LineWriter, Lines          ByteWriter, ByteItems
 * </pre>
 *
 * <p>Whoever stores more than a snapshot, as a journal does, writes it around these. This package may use {@code
 * org.evoloop.engine}, {@code org.evoloop.evolution} and {@code org.evoloop.statemachine}. Files and streams are up to its
 * users.
 */
@NullMarked
package org.evoloop.engine.codec;

import org.jspecify.annotations.NullMarked;
