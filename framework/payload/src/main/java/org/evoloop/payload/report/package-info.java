/**
 * Devices that report their state when they like, such as those behind a broker: which report counts, {@link
 * org.evoloop.payload.report.Aftermath}, and whether a command has been carried out, {@link
 * org.evoloop.payload.report.ConfirmedSending}. How reports come is left to a {@link
 * org.evoloop.payload.report.ReportingDevice}.
 *
 * <p>It uses the package {@code payload}, and the core.
 */
@NullMarked
package org.evoloop.payload.report;

import org.jspecify.annotations.NullMarked;
