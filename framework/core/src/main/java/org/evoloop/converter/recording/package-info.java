/**
 * What is written down of a converter's events, and who is told of them.
 *
 * <ul>
 *   <li>{@link org.evoloop.converter.recording.Records}: all of the following for one converter.
 *   <li>{@link org.evoloop.converter.recording.Transcript}: the paper's log.
 *   <li>{@link org.evoloop.converter.recording.FailureLog}: the log of failures and warnings, which a flood does not fill.
 *   <li>{@link org.evoloop.converter.recording.History}: the last events, each a {@link
 *       org.evoloop.converter.recording.HistoryLine}; {@link org.evoloop.converter.recording.Replayed} fills it from a
 *       journal.
 *   <li>{@link org.evoloop.converter.recording.LatencyWindow}: the last conversion times.
 *   <li>{@link org.evoloop.converter.recording.FlightLog}: Java Flight Recorder.
 *   <li>{@link org.evoloop.converter.recording.Listeners}: the listeners, and the thread that calls them; with {@link
 *       org.evoloop.converter.recording.AwaitedEndings}: who waits for the outcome of what was submitted.
 * </ul>
 *
 * <p>No module exports this package. It may use {@code org.evoloop.converter}, {@code engine}, {@code flight} and what those
 * use.
 */
@NullMarked
package org.evoloop.converter.recording;

import org.jspecify.annotations.NullMarked;
