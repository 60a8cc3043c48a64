package org.evoloop.roomba.simulator.robot;

import java.util.Arrays;
import org.evoloop.roomba.oi.ActuatorCommand.Song;
import org.evoloop.roomba.simulator.body.Body;

/**
 * Stores songs and plays one at a time. The songs are stored one after the other: a song with more notes than its slot
 * holds overwrites those after it, and notes beyond the last slot are lost.
 */
final class Speaker {
    private static final double DURATIONS_PER_SECOND = 64;

    private final int[] durations = new int[Song.SONGS * Song.NOTES_PER_SONG];

    /** The number of notes of each song; 0 if it was never stored. */
    private final int[] lengths = new int[Song.SONGS];

    private int number;
    private double secondsLeft;

    void store(Song song) {
        int first = song.number() * Song.NOTES_PER_SONG;
        int length = Math.min(song.notes().size(), durations.length - first);
        for (int i = 0; i < length; i++) {
            durations[first + i] = song.notes().get(i).durationIn64thsOfSecond();
        }
        lengths[song.number()] = length;
        int rest = length - Song.NOTES_PER_SONG;
        for (int next = song.number() + 1; rest > 0; next++) {
            lengths[next] = Math.max(lengths[next], rest);
            rest -= Song.NOTES_PER_SONG;
        }
    }

    /** Plays a song from its start; one that was never stored is ignored. */
    void play(int songNumber) {
        if (lengths[songNumber] > 0) {
            int first = songNumber * Song.NOTES_PER_SONG;
            number = songNumber;
            secondsLeft =
                    Arrays.stream(durations, first, first + lengths[songNumber]).sum() / DURATIONS_PER_SECOND;
        }
    }

    void tick() {
        secondsLeft = Math.max(0, secondsLeft - Body.TICK_SECONDS);
    }

    /** The number of the song that is playing or played last. */
    int number() {
        return number;
    }

    boolean isPlaying() {
        return secondsLeft > 0;
    }
}
