/**
 * The Roomba converter: an event converter that gives a cleaning robot the functions Move and SpotWait.
 *
 * <p>This package may use everything else of this module and the framework.
 */
@NullMarked
package org.evoloop.roomba;

import org.jspecify.annotations.NullMarked;
