package org.evoloop.studio;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.evoloop.page.server.Answer;
import org.evoloop.page.server.PageServer;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.statemachine.ModelException;
import org.evoloop.studio.Analysis.Detail;
import org.evoloop.studio.Analysis.Direction;
import org.evoloop.studio.Analysis.View;
import org.evoloop.studio.Analysis.Written;
import org.evoloop.xmi.XmiMachine;

/**
 * Answers the page's requests.
 *
 * <p>Threading: thread-safe.
 */
final class Routes {
    private static final String CONVERTERS = "/api/converters/";

    private final Folder folder;
    private final Analysis analysis;
    private final Map<String, Action> actions;

    /** What a request asks for. */
    private interface Action {
        JsonObject perform(JsonRecord request);
    }

    Routes(Folder folder, Analysis analysis) {
        this.folder = folder;
        this.analysis = analysis;
        this.actions = Map.ofEntries(
                Map.entry("GET /api/files", request -> files()),
                Map.entry("GET /api/file", this::file),
                Map.entry("PUT /api/file", this::save),
                Map.entry("POST /api/draw", request -> analysis.draw(pair(request), view(request))),
                Map.entry("POST /api/check", this::check),
                Map.entry("POST /api/plan", this::plan),
                Map.entry("POST /api/edit", Edits::edit),
                Map.entry("POST /api/try", request -> Trial.run(pair(request).flat(), request)),
                Map.entry(
                        "POST /api/scenario",
                        request -> Trial.scenario(pair(request).flat(), request)),
                Map.entry("POST /api/property", request -> analysis.property(pair(request), request.text("property"))),
                Map.entry("POST /api/device", this::device),
                Map.entry("GET /api/converters", request -> Converters.names()));
    }

    void answer(HttpExchange exchange) throws IOException {
        String asked =
                exchange.getRequestMethod() + " " + exchange.getRequestURI().getPath();
        int status = Answer.OK;
        JsonObject answer;
        try {
            answer = perform(asked, exchange);
        } catch (RequestException refused) {
            status = refused.status();
            answer = refused.answer();
        } catch (MistakeException mistaken) {
            answer = new JsonObject().put("mistake", mistaken.mistake().json());
        } catch (ModelException | IllegalArgumentException senseless) {
            status = RequestException.BAD;
            answer = new JsonObject().put("error", senseless.getMessage());
        } catch (StackOverflowError | OutOfMemoryError tooMuch) {
            status = Answer.FAILED;
            answer = new JsonObject().put("error", "the models are too large for this");
        }
        Answer.send(exchange, status, "application/json", answer.toBytes());
    }

    private JsonObject perform(String asked, HttpExchange exchange) throws IOException {
        if (asked.matches("(?:GET|POST) " + CONVERTERS + "[^/]+")) {
            return converter(asked, exchange);
        }
        Action action = actions.get(asked);
        if (action == null) {
            throw new RequestException(RequestException.NOT_FOUND, "there is no " + asked);
        }
        String query = exchange.getRequestURI().getQuery();
        boolean isGet = asked.startsWith("GET");
        return action.perform(isGet ? parameters(query) : JsonRecord.of(PageServer.body(exchange)));
    }

    /** The only parameter that a GET has. */
    private static JsonRecord parameters(String query) {
        JsonObject parameters = new JsonObject();
        if (query != null && query.startsWith("path=")) {
            parameters.put("path", query.substring("path=".length()));
        }
        return JsonRecord.of(new String(parameters.toBytes(), StandardCharsets.US_ASCII));
    }

    private JsonObject files() {
        List<JsonObject> files = new ArrayList<>();
        for (String path : folder.files()) {
            if (Folder.isOfModels(path)) {
                List<String> machines = machines(path);
                if (!machines.isEmpty() || !path.matches("(?i).*\\.(md|markdown|xml)")) {
                    files.add(listed(path, "models").putTexts("machines", machines));
                }
            } else {
                files.add(listed(path, Folder.isDevice(path) ? "device" : "properties")
                        .putTexts("machines", List.of()));
            }
        }
        return new JsonObject().put("directory", folder.root().toString()).put("files", files);
    }

    private static JsonObject listed(String path, String kind) {
        return new JsonObject().put("path", path).put("kind", kind);
    }

    /** None if the file has no machine, or cannot be read. */
    private List<String> machines(String path) {
        try {
            return folder.models(path).machines().stream().map(XmiMachine::name).toList();
        } catch (ModelException unreadable) {
            return List.of();
        }
    }

    private JsonObject file(JsonRecord request) {
        String path = request.text("path");
        Folder.Read read = folder.read(path);
        return new JsonObject().put("path", path).put("text", read.text()).put("version", read.version());
    }

    private JsonObject save(JsonRecord request) {
        String version = folder.write(request.text("path"), request.text("text"), request.text("version", ""));
        return new JsonObject().put("version", version);
    }

    /** The properties are those of the request, or else those in the file beside the new model. */
    private JsonObject check(JsonRecord request) {
        Pair pair = pair(request);
        return analysis.check(
                pair,
                request.has("properties")
                        ? new Written("properties", request.text("properties"))
                        : folder.propertiesOf(
                                pair.evolved().path(), pair.evolved().name()));
    }

    private JsonObject plan(JsonRecord request) {
        return analysis.plan(pair(request), request.text("state"), request.text("event"), request.text("guard", ""));
    }

    private JsonObject device(JsonRecord request) {
        return DeviceTexts.problems(folder, request.text("path"), request.text("text"), new Texts(folder, request));
    }

    private JsonObject converter(String asked, HttpExchange exchange) throws IOException {
        String name = asked.substring(asked.lastIndexOf('/') + 1);
        if (asked.startsWith("GET")) {
            return Converters.status(name);
        }
        JsonRecord request = JsonRecord.of(PageServer.body(exchange));
        return request.text("command").equals("migrate") ? migrate(request) : Converters.command(name, request, folder);
    }

    /** What runs is what is on disk, or the pair that the request names as running. */
    private JsonObject migrate(JsonRecord request) {
        Texts saved = new Texts(folder, JsonRecord.of("{}"));
        JsonRecord running = request.inner("running").orElseGet(() -> inner(request, "pair"));
        return analysis.migrate(
                new Pair(source(saved, running, "original"), source(saved, running, "new")), pair(request));
    }

    private static JsonRecord inner(JsonRecord request, String name) {
        return request.inner(name).orElseThrow(() -> new RequestException("'" + name + "' is missing"));
    }

    private Pair pair(JsonRecord request) {
        JsonRecord pair = request.inner("pair")
                .orElseThrow(() -> new RequestException("'pair' is missing, with original, new and texts"));
        Texts texts = new Texts(folder, pair);
        return new Pair(source(texts, pair, "original"), source(texts, pair, "new"));
    }

    private static Source source(Texts texts, JsonRecord pair, String side) {
        return texts.source(
                pair.inner(side).orElseThrow(() -> new RequestException("'" + side + "' is missing in 'pair'")));
    }

    private static View view(JsonRecord request) {
        return new View(
                constant(Direction.class, request.text("direction", "right")),
                constant(Detail.class, request.text("view", "all")),
                request.text("around", ""));
    }

    private static <E extends Enum<E>> E constant(Class<E> type, String word) {
        for (E each : type.getEnumConstants()) {
            if (JsonObject.word(each).equals(word.toLowerCase(Locale.ROOT))) {
                return each;
            }
        }
        throw new RequestException("'" + word + "' is none of " + List.of(type.getEnumConstants()));
    }
}
