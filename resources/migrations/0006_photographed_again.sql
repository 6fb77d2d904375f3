-- Which front of an earlier plate a sherd had before it was photographed again.
CREATE INDEX history_front ON history (old) WHERE table_name = 'sherd' AND field = 'front';
