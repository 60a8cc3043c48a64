/**
 * What serves a page to this machine's browser: the JDK's server behind a {@link org.evoloop.page.server.Gate}, with
 * limits to what clients can use up, and documents without external content.
 *
 * <p>It knows no converter.
 */
@NullMarked
package org.evoloop.page.server;

import org.jspecify.annotations.NullMarked;
