/**
 * The event converter (paper, sections III to V): what a user extends, adds and gets back. To build a converter, extend
 * {@link org.evoloop.converter.EventMonitor}, {@link org.evoloop.converter.EventExecute} and {@link
 * org.evoloop.converter.StateKnowledge}, and put them together in a {@link
 * org.evoloop.converter.SystemEventConverter}.
 *
 * <ul>
 *   <li>Components: {@link org.evoloop.converter.EventMonitor} with {@link org.evoloop.converter.PushMonitor}, {@link
 *       org.evoloop.converter.PollingMonitor} and {@link org.evoloop.converter.TimetableMonitor}; {@link
 *       org.evoloop.converter.EventAnalyze}, {@link org.evoloop.converter.EventPlan}, {@link
 *       org.evoloop.converter.EventExecute}; between them, {@link org.evoloop.converter.Analysis} and {@link
 *       org.evoloop.converter.ChangePlan}.
 *   <li>Knowledge: {@link org.evoloop.converter.StateKnowledge}, {@link org.evoloop.converter.Effect}, {@link
 *       org.evoloop.converter.BoundTransition}.
 *   <li>What it tells: {@link org.evoloop.converter.ConverterStatus}, {@link org.evoloop.converter.HistoryEntry}, {@link
 *       org.evoloop.converter.Trouble}, and {@link org.evoloop.converter.ConverterListener} as it happens.
 *   <li>Other models: {@link org.evoloop.converter.Evolution}, {@link org.evoloop.converter.Probation}, {@link
 *       org.evoloop.converter.Shadow}.
 *   <li>What others provide: {@link org.evoloop.converter.ConverterJournal}, {@link org.evoloop.converter.DeviceLink}.
 * </ul>
 *
 * <p>How it works is in packages that no module exports, each on the next: {@code changing} on {@code running} on {@code
 * recording} on this one. So this package names none of them: {@link org.evoloop.converter.SystemEventConverter} finds its
 * {@link org.evoloop.converter.ConverterDelegate} as a service, and the components meet the converter in {@code attachment},
 * which lies below.
 *
 * <p>This package may use {@code org.evoloop.converter.attachment}, {@code converter.binding}, {@code loop}, {@code
 * evolution}, {@code function}, {@code engine}, {@code migration}, {@code rehearsal} and what those use.
 */
@NullMarked
package org.evoloop.converter;

import org.jspecify.annotations.NullMarked;
