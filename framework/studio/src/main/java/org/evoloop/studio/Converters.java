package org.evoloop.studio;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.service.Ctl;

/** The running converters, which are asked through their control sockets, as {@code ctl} does. */
final class Converters {
    private static final int MOST_SECONDS = 86_400;

    private Converters() {}

    static JsonObject names() {
        Answer answer = ask(List.of());
        return new JsonObject()
                .putTexts("names", answer.out().lines().toList())
                .put("note", answer.err().strip());
    }

    static JsonObject status(String name) {
        return JsonRecord.of(ask(List.of(name, "status", "--json")).require()).copy();
    }

    /** Gives a command; a model that it names is the one that is saved. */
    static JsonObject command(String name, JsonRecord request, Folder folder) {
        String command = request.text("command");
        List<String> words = new ArrayList<>(List.of(name));
        switch (command) {
            case "evolve" -> {
                words.addAll(List.of("evolve", model(request, folder)));
                if (request.has("original")) {
                    words.addAll(List.of("--original", reference(request.text("original"), folder)));
                }
                if (request.has("probation")) {
                    words.addAll(List.of("--probation", seconds(request)));
                }
            }
            case "shadow" ->
                words.addAll(request.has("new") ? List.of("shadow", model(request, folder)) : List.of("shadow"));
            case "off" -> words.addAll(List.of("shadow", "off"));
            case "promote", "rollback" -> words.add(command);
            default ->
                throw new RequestException(
                        "'" + command + "' is none of migrate, evolve, shadow, promote, off and rollback");
        }
        return new JsonObject().put("words", ask(words).require().strip());
    }

    private static String seconds(JsonRecord request) {
        long seconds = request.number("probation");
        if (seconds < 0 || seconds > MOST_SECONDS) {
            throw new RequestException("'probation' is " + seconds + "; give seconds, from 0 to " + MOST_SECONDS);
        }
        return String.valueOf(seconds);
    }

    private static String model(JsonRecord request, Folder folder) {
        return reference(request.text("new"), folder);
    }

    private static String reference(String written, Folder folder) {
        int hash = written.lastIndexOf('#');
        String path = hash < 0 ? written : written.substring(0, hash);
        return folder.require(path) + written.substring(path.length());
    }

    private record Answer(int status, String out, String err) {
        String require() {
            if (status != 0) {
                String message = err.isBlank() ? out : err;
                throw new RequestException(
                        RequestException.REFUSED, message.strip().replaceFirst("^error: ", ""));
            }
            return out;
        }
    }

    private static Answer ask(List<String> words) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int status = Ctl.run(words, utf8(out), utf8(err));
        return new Answer(status, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }

    private static PrintStream utf8(ByteArrayOutputStream bytes) {
        return new PrintStream(bytes, true, StandardCharsets.UTF_8);
    }
}
