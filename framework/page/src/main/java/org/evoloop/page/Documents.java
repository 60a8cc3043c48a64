package org.evoloop.page;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.util.List;
import java.util.ServiceLoader;
import java.util.function.Supplier;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.page.server.Answer;
import org.evoloop.page.server.PageServer;
import org.jspecify.annotations.Nullable;

/**
 * A document of a page, which costs nothing before the first request.
 *
 * <p>Threading: thread-safe.
 */
final class Documents {
    private final Document document;
    private final List<SystemEventConverter> converters;
    private @Nullable Supplier<byte[]> content;

    private Documents(Document document, List<SystemEventConverter> converters) {
        this.document = document;
        this.converters = converters;
    }

    /** Registers every available document at {@code server}. */
    static void serve(PageServer server, List<SystemEventConverter> converters) {
        for (Document each : ServiceLoader.load(Document.class, Document.class.getClassLoader())) {
            server.on("GET", each.path(), new Documents(each, converters)::answer);
        }
    }

    private void answer(HttpExchange exchange) throws IOException {
        Answer.send(exchange, Answer.OK, document.mediaType(), content().get());
    }

    private synchronized Supplier<byte[]> content() {
        Supplier<byte[]> prepared = content;
        if (prepared == null) {
            prepared = document.of(converters);
            content = prepared;
        }
        return prepared;
    }
}
