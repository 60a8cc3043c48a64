package org.evoloop.page;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.URI;
import java.net.URLEncoder;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Semaphore;
import java.util.function.Predicate;
import org.evoloop.console.Console;
import org.evoloop.console.ShadowJson;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.page.drawing.MachineDrawing;
import org.evoloop.page.server.Answer;
import org.evoloop.page.server.PageServer;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;

/**
 * A page in the browser that shows a converter's activity live.
 *
 * <pre>{@code
 * Page.open(options, console, System.err);
 * return service.run(console);
 * }</pre>
 *
 * <p>Anyone who can reach the address may look. To start, stop, exchange or press something, and to see private
 * pictures, the token is needed, which is printed once. With {@link PageOptions#none} nothing listens, and the page
 * costs nothing.
 *
 * <p>Threading: opened by the thread that sets up the console; closed on any, once or more. The converter never waits
 * for a viewer.
 *
 * @since 0.1
 */
public final class Page implements AutoCloseable {
    private static final int HISTORY_PAGE = 500;
    private static final int LONGEST_REQUEST = 4096;

    /** The number of newest differences of a shadow that are shown. */
    private static final int DIFFERENCES = 20;

    private final Console console;
    private final SystemEventConverter converter;
    private final List<Picture> pictures;
    private final Clock clock = new SystemClock();
    private final Controls controls;
    private final Semaphore readingHistory = new Semaphore(1);
    private final @Nullable PageServer server;
    private @Nullable String about;

    /** The models that it shows. */
    private @Nullable ModelPair drawn;

    private Page(PageOptions options, Console console, List<Picture> pictures) throws IOException {
        this.console = console;
        this.converter = console.converters().get(0);
        this.pictures = List.copyOf(pictures);
        this.controls = new Controls(console);
        this.server = options.isOn() ? new PageServer(options.place(), LONGEST_REQUEST, clock) : null;
    }

    /**
     * Serves a page of the console's first converter until the console ends, if the options say so.
     *
     * @param console the console with all its commands, not running yet; its converter is built
     * @param announcements receives the address and the token
     * @throws IOException if the address cannot be used; the message says what to do
     */
    public static Page open(PageOptions options, Console console, PrintStream announcements) throws IOException {
        return open(options, console, announcements, List.of());
    }

    /** As the other method, with pictures beside the models. */
    public static Page open(PageOptions options, Console console, PrintStream announcements, List<Picture> pictures)
            throws IOException {
        Page page = new Page(options, console, pictures);
        PageServer server = page.server;
        if (server != null) {
            page.serve(server);
            console.onEnd(reason -> page.close());
            boolean everywhere = options.host().matches("0\\.0\\.0\\.0|\\[::]|\\[0:.*");
            String address = address(everywhere ? "127.0.0.1" : options.host(), server.port());
            console.shownAt(URI.create(everywhere ? address(machine(), server.port()) : address));
            announcements.println("page: " + address + " to look, " + address + "#token="
                    + server.gate().token() + " to control");
        }
        return page;
    }

    private static String address(String host, int port) {
        return "http://" + host + ":" + port + "/";
    }

    /** The name under which others reach this machine. */
    private static String machine() {
        try {
            return InetAddress.getLocalHost().getHostName();
        } catch (UnknownHostException nameless) {
            return "localhost";
        }
    }

    private void serve(PageServer to) {
        file(to, "/", "index.html", "text/html; charset=utf-8");
        for (String script : List.of("page", "dom", "drawing", "now", "choices", "models", "events", "why", "rest")) {
            file(to, "/" + script + ".js", script + ".js", "text/javascript; charset=utf-8");
        }
        for (String sheet : List.of("style", "page")) {
            file(to, "/" + sheet + ".css", sheet + ".css", "text/css; charset=utf-8");
        }
        file(to, "/icon.svg", "icon.svg", "image/svg+xml");
        Broadcast broadcast = new Broadcast(converter, clock);
        to.onStream("/events", exchange -> new Stream(broadcast, to.threads(), clock).serve(exchange));
        to.on("GET", "/about", exchange -> Answer.json(exchange, about()));
        to.on("GET", "/history", this::history);
        to.on("GET", "/shadow", this::shadow);
        to.on("GET", "/picture", exchange -> picture(to, exchange));
        to.on("GET", "/controls", exchange -> controls(to, exchange));
        to.session(() -> controls.offered().toString());
        to.on("POST", "/command", exchange -> command(to, exchange));
        Documents.serve(to, console.converters());
        to.start();
    }

    private static void file(PageServer to, String path, String name, String mediaType) {
        to.file(path, mediaType, () -> Page.class.getResourceAsStream(name));
    }

    private synchronized String about() {
        ModelPair models = converter.knowledge().models();
        String known = about;
        if (known == null || !models.equals(drawn)) {
            known = describe(models).toString();
            about = known;
            drawn = models;
        }
        return known;
    }

    private JsonObject describe(ModelPair models) {
        return new JsonObject()
                .put("name", converter.status().name())
                .put("original", machine(models.original(), state -> false))
                .put("new", machine(models.evolved(), models::isNew))
                .put(
                        "pictures",
                        pictures.stream()
                                .map(picture -> new JsonObject()
                                        .put("name", picture.name())
                                        .put("description", picture.description())
                                        .put("private", picture.isPrivate()))
                                .toList());
    }

    private static JsonObject machine(StateMachine machine, Predicate<State> added) {
        return new JsonObject()
                .put("name", machine.name())
                .put("all", MachineDrawing.of(machine, added))
                .put("overview", MachineDrawing.overview(machine, added))
                .putTexts(
                        "triggers", machine.triggers().stream().map(Event::name).toList())
                .put(
                        "states",
                        machine.states().stream()
                                .map(state -> new JsonObject()
                                        .put("name", state.name())
                                        .put(
                                                "drawn",
                                                machine.withoutMemory(state).name())
                                        .putTexts("around", MachineDrawing.around(machine, state))
                                        .put("added", added.test(state)))
                                .toList());
    }

    /** The events before a given one; a journal reaches far back, and reading it takes a while. */
    private void history(HttpExchange exchange) throws IOException {
        long before = number(exchange, "before", Long.MAX_VALUE);
        if (!readingHistory.tryAcquire()) {
            Answer.text(exchange, Answer.BUSY, "another request is reading the history; try again");
            return;
        }
        try {
            List<HistoryEntry> newest = converter.history();
            long last = newest.isEmpty() ? 0 : newest.get(newest.size() - 1).number();
            long wanted = Math.max(1, last - Math.min(before, last + 1) + 1 + HISTORY_PAGE);
            List<HistoryEntry> entries =
                    converter.history((int) Math.min(SystemEventConverter.MOST_HISTORY, wanted)).stream()
                            .filter(entry -> entry.number() < before)
                            .toList();
            List<HistoryEntry> page = entries.subList(Math.max(0, entries.size() - HISTORY_PAGE), entries.size());
            Answer.json(
                    exchange,
                    new JsonObject()
                            .put("events", page.stream().map(EntryJson::of).toList())
                            .toString());
        } finally {
            readingHistory.release();
        }
    }

    private void shadow(HttpExchange exchange) throws IOException {
        Answer.json(exchange, shadowJson().toString());
    }

    private JsonObject shadowJson() {
        try {
            return converter
                    .shadow()
                    .map(shadow -> ShadowJson.of(shadow.report(), DIFFERENCES))
                    .orElseGet(JsonObject::new);
        } catch (IllegalStateException ended) {
            return new JsonObject();
        }
    }

    private void picture(PageServer from, HttpExchange exchange) throws IOException {
        long number = number(exchange, "number", 0);
        if (number >= pictures.size()) {
            Answer.text(exchange, Answer.NOT_FOUND, "there are " + pictures.size() + " pictures");
        } else if (pictures.get((int) number).isPrivate() && !from.gate().isAdmitted(exchange)) {
            Answer.notAdmitted(exchange);
        } else {
            Picture picture = pictures.get((int) number);
            Picture.View view = picture.view().get();
            // Encoded, since a header takes ASCII only.
            exchange.getResponseHeaders()
                    .set(
                            "Picture-Note",
                            URLEncoder.encode(view.note(), StandardCharsets.UTF_8)
                                    .replace("+", "%20"));
            boolean none = view.content().length == 0;
            Answer.send(exchange, none ? Answer.NO_CONTENT : Answer.OK, picture.mediaType(), view.content());
        }
    }

    private static long number(HttpExchange exchange, String name, long otherwise) {
        String query = exchange.getRequestURI().getRawQuery();
        for (String each : query == null ? new String[0] : query.split("&", -1)) {
            if (each.matches(name + "=[0-9]{1,18}")) {
                return Long.parseLong(each.substring(name.length() + 1));
            }
        }
        return otherwise;
    }

    private void controls(PageServer from, HttpExchange exchange) throws IOException {
        if (from.gate().isAdmitted(exchange)) {
            Answer.json(exchange, controls.offered().toString());
        } else {
            Answer.notAdmitted(exchange);
        }
    }

    private void command(PageServer from, HttpExchange exchange) throws IOException, InterruptedException {
        String line = PageServer.body(exchange);
        if (!from.gate().isAdmitted(exchange)) {
            Answer.notAdmitted(exchange);
        } else if (line.isBlank() || console.isEnding()) {
            Answer.text(exchange, Answer.BAD_REQUEST, "there is no command, or the program is about to end");
        } else {
            Answer.json(exchange, controls.perform(line).toString());
        }
    }

    /** The address, for tests. */
    int port() {
        return Objects.requireNonNull(server, "there is no page").port();
    }

    @Override
    public void close() {
        if (server != null) {
            server.close();
        }
        clock.close();
    }
}
