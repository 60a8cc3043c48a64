package org.evoloop.page.server;

import org.jspecify.annotations.Nullable;

/**
 * Where a page is served.
 *
 * <p>Threading: immutable.
 *
 * @param option the option that says so, for messages
 * @param host the host name or address to listen on
 * @param port the port, 0 for any free one
 * @param tokenFile keeps the token for the next start; null for a new token at each start
 * @since 0.1
 */
public record ServerPlace(
        String option, String host, int port, @Nullable TokenFile tokenFile) {}
